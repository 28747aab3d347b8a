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

/// Milliseconds from one frame of the display to the next beyond which pictures stutter: of
/// sixty frames a second, every other is missed.
const BUDGET: f32 = 25.0;
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
        if self.milliseconds[PICTURES / 4] > BUDGET {
            self.affordable = match self.affordable {
                Effects::Occlusion => Effects::Shadow,
                Effects::Shadow | Effects::None => Effects::None,
            };
        }
        self.milliseconds.clear();
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

    fn after(quality: &mut Quality, milliseconds: &[f32]) -> Effects {
        for &ms in milliseconds {
            quality.record(ms);
        }
        quality.effects(Wish::Auto)
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
    fn software_draws_effects_only_when_asked() {
        let quality = Quality::new(true);
        assert_eq!(quality.effects(Wish::Auto), Effects::None);
        assert_eq!(quality.effects(Wish::Always), Effects::Occlusion);
        assert_eq!(Quality::new(false).effects(Wish::Never), Effects::None);
    }
}
