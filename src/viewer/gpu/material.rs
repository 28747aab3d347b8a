//! What surface and background bind as group 1: the colour map, how open the surface is,
//! its shadow.

use super::device::Gpu;
use super::texture::{self, read_entry, sampler_entry, smooth_entry};
use crate::viewer::colour::{ColourMap, MAP_LENGTH, map_texels};

/// Group 1 of the pipelines of surface and background.
pub(super) struct Material {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
    map: wgpu::Texture,
    sent_map: Option<ColourMap>,
    sampler: wgpu::Sampler,
}

impl Material {
    pub(super) fn new(
        gpu: &Gpu,
        openness: &wgpu::TextureView,
        footprint: &wgpu::TextureView,
    ) -> Self {
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("material"),
                entries: &[
                    smooth_entry(0),
                    sampler_entry(1),
                    read_entry(
                        2,
                        wgpu::ShaderStages::FRAGMENT,
                        wgpu::TextureViewDimension::D2,
                    ),
                    smooth_entry(3),
                ],
            });
        let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        let format = wgpu::TextureFormat::Rgba8UnormSrgb;
        let map = texture::data(gpu, format, (MAP_LENGTH as u32, 1, 1));
        Self {
            group: group(gpu, &layout, &map, &sampler, openness, footprint),
            layout,
            map,
            sent_map: None,
            sampler,
        }
    }

    /// Takes other pictures of openness and shadow.
    pub(super) fn set_effects(
        &mut self,
        gpu: &Gpu,
        openness: &wgpu::TextureView,
        footprint: &wgpu::TextureView,
    ) {
        self.group = group(
            gpu,
            &self.layout,
            &self.map,
            &self.sampler,
            openness,
            footprint,
        );
    }

    /// Sends a colour map.
    pub(super) fn set_map(&mut self, gpu: &Gpu, map: ColourMap) {
        if self.sent_map != Some(map) {
            self.sent_map = Some(map);
            texture::write(gpu, &self.map, 0, &map_texels(map));
        }
    }
}

fn group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    map: &wgpu::Texture,
    sampler: &wgpu::Sampler,
    openness: &wgpu::TextureView,
    footprint: &wgpu::TextureView,
) -> wgpu::BindGroup {
    let map = map.create_view(&Default::default());
    texture::group(
        gpu,
        layout,
        &[
            wgpu::BindingResource::TextureView(&map),
            wgpu::BindingResource::Sampler(sampler),
            wgpu::BindingResource::TextureView(openness),
            wgpu::BindingResource::TextureView(footprint),
        ],
    )
}
