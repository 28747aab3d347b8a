//! Long work tells here how far it has come, and learns here whether it is to be given up.
//!
//! There is one observer a thread, set for as long as a piece of work takes, as there is one
//! logger: what is deep inside, a factorisation or a loop over vertices, asks without knowing who
//! wants to know, and no function in between has to hand anything on. Where nobody observes,
//! asking costs a few instructions.
//!
//! Once work is to be given up it stays so until it ends: whoever asks is refused again. So a
//! loop may just leave off with half a result, as long as whoever began the work looks at
//! [`is_interrupted`] before using it.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::rc::Rc;

/// Told a stage's name and the share of the work done; breaks where the work is to be given up.
/// It is asked every few milliseconds or more often, with what was told last.
pub type Progress = Rc<dyn Fn(&str, f64) -> ControlFlow<()>>;

/// The work is to be given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted;

struct Observed {
    progress: Progress,
    stage: &'static str,
    share: f64,
    is_interrupted: bool,
    is_certain: bool,
}

thread_local! {
    static OBSERVED: RefCell<Option<Observed>> = const { RefCell::new(None) };
}

/// Does `work`, observed. What is observed already stays so, by whom it is.
pub fn observed<T>(progress: Option<Progress>, work: impl FnOnce() -> T) -> T {
    /// Ends the observation also where the work panics.
    struct End;
    impl Drop for End {
        fn drop(&mut self) {
            OBSERVED.take();
        }
    }
    let Some(progress) = progress.filter(|_| OBSERVED.with_borrow(Option::is_none)) else {
        return work();
    };
    OBSERVED.set(Some(Observed {
        progress,
        stage: "",
        share: 0.0,
        is_interrupted: false,
        is_certain: false,
    }));
    let _end = End;
    work()
}

/// Tells how far the work has come.
pub fn tell(stage: &'static str, share: f64) {
    OBSERVED.with_borrow_mut(|observed| {
        if let Some(observed) = observed {
            (observed.stage, observed.share) = (stage, share);
        }
    });
    ask();
}

/// A sign of life, where there is nothing to give up.
pub fn pulse() {
    ask();
}

/// Asks whether to go on.
///
/// # Errors
/// [`Interrupted`] where the work is to be given up.
pub fn check() -> Result<(), Interrupted> {
    ask();
    if is_interrupted() {
        Err(Interrupted)
    } else {
        Ok(())
    }
}

/// From here on the work at hand is not given up any more, as it begins to change what must not be
/// left half changed; who observes it is told on.
///
/// # Errors
/// [`Interrupted`] where it is to be given up already.
pub fn commit() -> Result<(), Interrupted> {
    check()?;
    OBSERVED.with_borrow_mut(|observed| {
        if let Some(observed) = observed {
            observed.is_certain = true;
        }
    });
    Ok(())
}

/// Items of a [`paced`] loop between two asks.
const PACE: u32 = 4096;

/// The items, with an ask every few thousand; they end early where the work is to be given up. For
/// long loops over elements whose half result does no harm.
pub fn paced<I: IntoIterator>(items: I) -> impl Iterator<Item = I::Item> {
    let mut left = 0;
    items.into_iter().take_while(move |_| {
        if left == 0 {
            left = PACE;
            if check().is_err() {
                return false;
            }
        }
        left -= 1;
        true
    })
}

/// Whether somebody has been told to give the work up.
pub fn is_interrupted() -> bool {
    OBSERVED.with_borrow(|observed| observed.as_ref().is_some_and(|o| o.is_interrupted))
}

/// The observer may look at anything but may not observe another piece of work meanwhile.
fn ask() {
    let asked = OBSERVED.with_borrow(|observed| {
        let observed = observed.as_ref().filter(|o| !o.is_interrupted)?;
        Some((
            Rc::clone(&observed.progress),
            observed.stage,
            observed.share,
        ))
    });
    let Some((progress, stage, share)) = asked else {
        return;
    };
    if progress(stage, share).is_break() {
        OBSERVED.with_borrow_mut(|observed| {
            if let Some(observed) = observed {
                observed.is_interrupted = !observed.is_certain;
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::{Cell, RefCell};

    #[test]
    fn who_breaks_once_is_not_asked_again() {
        let told = Rc::new(RefCell::new(Vec::new()));
        let heard = Rc::clone(&told);
        let progress: Progress = Rc::new(move |stage, share| {
            heard.borrow_mut().push((stage.to_owned(), share));
            if heard.borrow().len() == 3 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        assert_eq!(check(), Ok(()));
        observed(Some(progress), || {
            tell("assemble", 0.25);
            assert_eq!(check(), Ok(()));
            assert!(!is_interrupted());
            assert_eq!(check(), Err(Interrupted));
            tell("solve", 0.5);
            assert_eq!(check(), Err(Interrupted));
            assert!(is_interrupted());
        });
        let assembling = ("assemble".to_owned(), 0.25);
        assert_eq!(*told.borrow(), vec![assembling; 3]);
        assert!(!is_interrupted());
        assert_eq!(check(), Ok(()));
    }

    /// Refuses the ask of that number and those after it.
    fn refusing(nth: usize) -> (Option<Progress>, Rc<Cell<usize>>) {
        let asked = Rc::new(Cell::new(0));
        let count = Rc::clone(&asked);
        let progress = move |_: &str, _: f64| {
            count.set(count.get() + 1);
            match count.get() < nth {
                true => ControlFlow::Continue(()),
                false => ControlFlow::Break(()),
            }
        };
        (Some(Rc::new(progress)), asked)
    }

    #[test]
    fn a_paced_loop_asks_now_and_then_and_ends_early() {
        let items = 3 * PACE;
        let count = || paced(0..items).count() as u32;
        assert_eq!(count(), items);
        let (progress, asked) = refusing(usize::MAX);
        assert_eq!(observed(progress, count), items);
        assert_eq!(asked.get(), 3);
        let (progress, _) = refusing(2);
        // A second loop does not begin.
        assert_eq!(observed(progress, || [count(), count()]), [PACE, 0]);
    }

    #[test]
    fn what_is_certain_is_not_given_up_but_goes_on_telling() {
        let (progress, asked) = refusing(2);
        observed(progress, || {
            assert_eq!(commit(), Ok(()));
            assert_eq!(check(), Ok(()));
            tell("after", 0.5);
            assert!(!is_interrupted());
        });
        assert_eq!(asked.get(), 3);
        let (progress, _) = refusing(1);
        observed(progress, || assert_eq!(commit(), Err(Interrupted)));
    }

    #[test]
    fn work_within_work_is_observed_by_whom_the_whole_is() {
        let calls = [Rc::new(Cell::new(0)), Rc::new(Cell::new(0))];
        let counting = |calls: &Rc<Cell<i32>>| -> Option<Progress> {
            let calls = Rc::clone(calls);
            Some(Rc::new(move |_, _| {
                calls.set(calls.get() + 1);
                ControlFlow::Continue(())
            }))
        };
        observed(counting(&calls[0]), || {
            observed(counting(&calls[1]), || tell("inside", 0.0));
            tell("outside", 0.0);
        });
        assert_eq!(calls.map(|calls| calls.get()), [2, 0]);
    }
}
