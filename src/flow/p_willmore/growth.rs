//! Where nothing keeps a surface from growing for ever.

use super::PWillmoreFlow;
use crate::energy::p_willmore::Helfrich;

impl PWillmoreFlow {
    /// ∫|H|^p goes with R^(2−p): for p > 2 there is always a larger surface with less of it.
    pub(super) fn grows(&self) -> bool {
        self.options.p > 2.0 && !self.kept.any() && self.functional.helfrich().is_zero()
    }

    /// With these terms a large sphere has as little of the functional as one likes; a smaller surface
    /// may be at rest.
    pub(super) fn is_unbounded(&self) -> bool {
        let Helfrich {
            tension, pressure, ..
        } = self.functional.helfrich();
        !self.kept.any() && (pressure > 0.0 || tension < 0.0)
    }
}
