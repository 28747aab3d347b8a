//! How much is drawn beyond surface and lines: what the device has time for.
//!
//! Darkened corners and a shadow help the eye, but a picture that stutters does not. Frames
//! are timed; where they take too long, the dearer effect is given up first. Nothing comes
//! back by itself: switching to and fro would be seen more than either.

/// What the page asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wish {
    /// What the device has time for; nothing where it draws in software.
    #[default]
    Auto,
    /// All of it, however long it takes.
    Always,
    /// None of it.
    Never,
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effects {
    /// Surface and lines only.
    None,
    /// The shadow on the floor as well.
    Shadow,
    /// Corners are darkened as well.
    Occlusion,
}

/// Milliseconds from handing a picture to the device until it is done, beyond which it is
/// too slow: sixty pictures a second leave 16.7, of which the browser needs some.
const BUDGET: f32 = 12.0;
/// Pictures that are looked at together.
const PICTURES: usize = 12;

/// What has been seen of the device.
#[derive(Clone, Debug)]
pub struct Quality {
    affordable: Effects,
    milliseconds: Vec<f32>,
}

impl Quality {
    /// Nothing measured yet.
    pub fn new(is_software: bool) -> Self {
        Self {
            affordable: if is_software {
                Effects::None
            } else {
                Effects::Occlusion
            },
            milliseconds: Vec::with_capacity(PICTURES),
        }
    }

    /// Takes note of how long a picture took; says whether less is drawn from now on.
    ///
    /// A page that was busy learns late that a picture was done. So of [`PICTURES`] the
    /// slower three quarters are not believed.
    pub fn record(&mut self, milliseconds: f32) -> bool {
        self.milliseconds.push(milliseconds);
        if self.milliseconds.len() < PICTURES {
            return false;
        }
        self.milliseconds.sort_unstable_by(f32::total_cmp);
        let is_slow = self.milliseconds[PICTURES / 4] > BUDGET;
        self.milliseconds.clear();
        let less = match self.affordable {
            Effects::Occlusion => Effects::Shadow,
            Effects::Shadow | Effects::None => Effects::None,
        };
        is_slow && std::mem::replace(&mut self.affordable, less) != less
    }

    /// What is drawn where the page has such a wish.
    pub fn effects(&self, wish: Wish) -> Effects {
        match wish {
            Wish::Auto => self.affordable,
            Wish::Always => Effects::Occlusion,
            Wish::Never => Effects::None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(quality: &mut Quality, milliseconds: &[f32]) -> usize {
        milliseconds
            .iter()
            .filter(|&&ms| quality.record(ms))
            .count()
    }

    #[test]
    fn a_slow_device_gives_up_the_dearer_effect_first() {
        let mut quality = Quality::new(false);
        assert_eq!(quality.effects(Wish::Auto), Effects::Occlusion);
        assert_eq!(record(&mut quality, &[30.0; PICTURES]), 1);
        assert_eq!(quality.effects(Wish::Auto), Effects::Shadow);
        assert_eq!(record(&mut quality, &[5.0; 5 * PICTURES]), 0);
        assert_eq!(
            quality.effects(Wish::Auto),
            Effects::Shadow,
            "none comes back"
        );
        assert_eq!(record(&mut quality, &[30.0; 5 * PICTURES]), 1);
        assert_eq!(quality.effects(Wish::Auto), Effects::None);
    }

    #[test]
    fn a_busy_page_does_not_count() {
        let mut quality = Quality::new(false);
        let mut late = [300.0; PICTURES];
        late[..4].fill(4.0);
        assert_eq!(record(&mut quality, &late), 0);
        assert_eq!(quality.effects(Wish::Auto), Effects::Occlusion);
    }

    #[test]
    fn software_draws_effects_only_when_asked() {
        let quality = Quality::new(true);
        assert_eq!(quality.effects(Wish::Auto), Effects::None);
        assert_eq!(quality.effects(Wish::Always), Effects::Occlusion);
        assert_eq!(Quality::new(false).effects(Wish::Never), Effects::None);
    }
}
