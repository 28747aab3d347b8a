//! What is drawn beyond surface and lines, and how long pictures take with it.

use std::sync::{Arc, Mutex, PoisonError};

use web_time::Instant;

use super::bindings::Bindings;
use super::device::Gpu;
use super::filter::Reading;
use super::occlusion_pass::OcclusionPass;
use super::shadow_pass::ShadowPass;
use super::surface_pass::SurfacePass;
use crate::viewer::quality::{Effects, Quality, Wish};

/// The passes of the effects.
pub(super) struct EffectPasses {
    reading: Reading,
    pub(super) occlusion: OcclusionPass,
    pub(super) shadow: ShadowPass,
    quality: Quality,
    clock: Clock,
}

/// Milliseconds that pictures took, as they are known.
type Times = Arc<Mutex<Vec<f32>>>;

/// Times one picture at a time.
#[derive(Default)]
struct Clock {
    is_running: bool,
    times: Times,
}

impl EffectPasses {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings) -> Self {
        let reading = Reading::new(gpu);
        Self {
            occlusion: OcclusionPass::new(gpu, bindings, &reading),
            shadow: ShadowPass::new(gpu, bindings, &reading),
            reading,
            quality: Quality::new(gpu.is_software),
            clock: Clock::default(),
        }
    }

    /// What is drawn where the page has such a wish.
    pub(super) fn chosen(&self, wish: Wish) -> Effects {
        self.quality.effects(wish)
    }

    /// Makes the pictures that are needed; says whether they are others than before.
    pub(super) fn prepare(&mut self, gpu: &Gpu, chosen: Effects) -> bool {
        chosen >= Effects::Occlusion && self.occlusion.resize(gpu, &self.reading, gpu.size())
    }

    /// Draws them.
    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        bindings: &Bindings,
        surface: &SurfacePass,
        chosen: Effects,
    ) {
        if chosen >= Effects::Shadow {
            self.shadow.draw(encoder, bindings, surface);
        }
        if chosen >= Effects::Occlusion {
            self.occlusion.draw(encoder, bindings, surface);
        }
    }

    /// Times the picture that has just been submitted, and takes those into account that are
    /// done; says whether less is affordable than before.
    pub(super) fn time(&mut self, gpu: &Gpu) -> bool {
        let done = std::mem::take(&mut *lock(&self.clock.times));
        self.clock.is_running &= done.is_empty();
        if !self.clock.is_running {
            self.clock.is_running = true;
            let (start, times) = (Instant::now(), Arc::clone(&self.clock.times));
            gpu.queue.on_submitted_work_done(move || {
                lock(&times).push(1000.0 * start.elapsed().as_secs_f32());
            });
            #[cfg(feature = "viewer-webgl")]
            {
                let (device, times) = (gpu.device.clone(), Arc::clone(&self.clock.times));
                wasm_bindgen_futures::spawn_local(async move {
                    let is_done = || !lock(&times).is_empty();
                    super::polling::poll_until(&device, is_done).await;
                });
            }
        }
        let mut is_less = false;
        for milliseconds in done {
            is_less |= self.quality.record(milliseconds);
        }
        is_less
    }
}

fn lock(times: &Times) -> std::sync::MutexGuard<'_, Vec<f32>> {
    times.lock().unwrap_or_else(PoisonError::into_inner)
}
