//! The part of the program that is fetched when it is first needed.
//!
//! What a browser loads first draws a sample and runs the flow by circle angles; all else is in a
//! second wasm file, of which the calls into `deferred!` functions are the only ways in. The
//! linker's output is taken apart along these calls by `src/bin/splitter.rs`, where the feature
//! `split` is on; without it, as in native builds and the development server's, such a function is
//! like any other.
//!
//! Fetching is done in the middle of the call (`www/deferred.js`), so that callers need not wait
//! for anything. Where it fails the call panics: whatever is asked of a session from outside
//! [loads](load) the part first.

/// Declares a function of the deferred part.
macro_rules! deferred {
    ($(#[$attribute:meta])*
     $vis:vis fn $name:ident($($argument:ident: $type:ty),* $(,)?) -> $result:ty $body:block) => {
        $(#[$attribute])*
        #[cfg(not(feature = "split"))]
        $vis fn $name($($argument: $type),*) -> $result $body

        $(#[$attribute])*
        #[cfg(feature = "split")]
        #[allow(unsafe_code, reason = "exports a symbol, for the splitter to find")]
        $vis fn $name($($argument: $type),*) -> $result {
            #[wasm_split_helpers::wasm_split(deferred)]
            fn $name($($argument: $type),*) -> $result $body

            $crate::deferred::at_once($name($($argument),*))
        }
    };
}

/// Fetches the part, unless it is there: whether it is there now.
#[must_use]
pub fn load() -> bool {
    #[cfg(feature = "split")]
    return at_once(split::part()).is_ok();
    #[cfg(not(feature = "split"))]
    true
}

/// What a call of a function comes to that has nothing to wait for.
#[cfg(feature = "split")]
pub(crate) fn at_once<T>(call: impl Future<Output = T>) -> T {
    use std::task::{Context, Poll, Waker};
    let mut call = std::pin::pin!(call);
    let mut context = Context::from_waker(Waker::noop());
    // The first begins to fetch, and is told of the end of it while it does.
    for _ in 0..3 {
        if let Poll::Ready(result) = call.as_mut().poll(&mut context) {
            return result;
        }
    }
    unreachable!("the part is fetched within the call that asks for it")
}

#[cfg(feature = "split")]
#[allow(unsafe_code, reason = "exports a symbol, for the splitter to find")]
mod split {
    use wasm_split_helpers::{SplitLoaderError, wasm_split};

    #[wasm_split(deferred, fallible)]
    pub(super) fn part() -> Result<(), SplitLoaderError> {
        Ok(())
    }
}
