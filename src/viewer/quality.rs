//! How much is drawn beyond surface and lines: what the device has time for.
//!
//! Darkened corners and a shadow help the eye, but a picture that stutters does not. Frames
//! are timed; where they take too long, the dearer effect is given up first, for as long as
//! anything moves: a picture at rest has the time. Nothing else comes back by itself, as switching
//! to and fro would be seen more than either.

/// What the page asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wish {
    /// What the device has time for: in software corners only at rest.
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

/// Milliseconds from one frame of the display to the next beyond which pictures stutter: of
/// sixty frames a second, every other is missed.
const BUDGET: f32 = 25.0;
/// The same of a device that draws in software, where the shadow is a tenth of the picture.
const SOFTWARE_BUDGET: f32 = 250.0;
/// Pictures that are looked at together.
const PICTURES: usize = 12;

/// What has been seen of the device.
#[derive(Clone, Debug)]
pub struct Quality {
    affordable: Effects,
    budget: f32,
    milliseconds: Vec<f32>,
}

impl Quality {
    /// Nothing measured yet.
    pub fn new(is_software: bool) -> Self {
        let (affordable, budget) = if is_software {
            (Effects::Shadow, SOFTWARE_BUDGET)
        } else {
            (Effects::Occlusion, BUDGET)
        };
        Self {
            affordable,
            budget,
            milliseconds: Vec::with_capacity(PICTURES),
        }
    }

    /// Takes note of how long a frame took in which a picture was drawn.
    ///
    /// A page that is busy with something else is late too, now and then. So of `PICTURES`
    /// frames the slower three quarters are not believed.
    pub fn record(&mut self, milliseconds: f32) {
        self.milliseconds.push(milliseconds);
        if self.milliseconds.len() < PICTURES {
            return;
        }
        self.milliseconds.sort_unstable_by(f32::total_cmp);
        if self.milliseconds[PICTURES / 4] > self.budget {
            self.affordable = match self.affordable {
                Effects::Occlusion => Effects::Shadow,
                Effects::Shadow | Effects::None => Effects::None,
            };
        }
        self.milliseconds.clear();
    }

    /// What is drawn where the page has such a wish, of a picture that moves or is still.
    pub fn effects(&self, wish: Wish, is_still: bool) -> Effects {
        match wish {
            Wish::Auto if is_still && self.affordable > Effects::None => Effects::Occlusion,
            Wish::Auto => self.affordable,
            Wish::Always => Effects::Occlusion,
            Wish::Never => Effects::None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(quality: &mut Quality, milliseconds: &[f32]) -> Effects {
        for &ms in milliseconds {
            quality.record(ms);
        }
        quality.effects(Wish::Auto, false)
    }

    #[test]
    fn a_slow_device_gives_up_the_dearer_effect_first() {
        let mut quality = Quality::new(false);
        let slow = [33.3; PICTURES];
        assert_eq!(after(&mut quality, &slow[1..]), Effects::Occlusion);
        assert_eq!(after(&mut quality, &slow[..1]), Effects::Shadow);
        let fast = [16.7; 5 * PICTURES];
        assert_eq!(
            after(&mut quality, &fast),
            Effects::Shadow,
            "none comes back"
        );
        assert_eq!(after(&mut quality, &slow), Effects::None);
        assert_eq!(after(&mut quality, &slow), Effects::None);
    }

    #[test]
    fn a_busy_page_does_not_count() {
        let mut late = [300.0; PICTURES];
        late[..4].fill(16.7);
        assert_eq!(after(&mut Quality::new(false), &late), Effects::Occlusion);
    }

    #[test]
    fn a_picture_at_rest_has_the_time_unless_the_shadow_was_too_much() {
        let mut quality = Quality::new(true);
        assert_eq!(quality.effects(Wish::Auto, false), Effects::Shadow);
        assert_eq!(quality.effects(Wish::Auto, true), Effects::Occlusion);
        assert_eq!(after(&mut quality, &[240.0; PICTURES]), Effects::Shadow);
        assert_eq!(after(&mut quality, &[260.0; PICTURES]), Effects::None);
        assert_eq!(quality.effects(Wish::Auto, true), Effects::None);
    }

    #[test]
    fn a_wish_is_met() {
        for (is_software, is_still) in [(false, false), (false, true), (true, false), (true, true)]
        {
            let quality = Quality::new(is_software);
            assert_eq!(quality.effects(Wish::Never, is_still), Effects::None);
            assert_eq!(quality.effects(Wish::Always, is_still), Effects::Occlusion);
        }
    }
}
