//! Repair: what keeps a file, or the surface at hand, from being a whole surface.

use super::options::RepairOptions;
use crate::app::document::{Document, Opened, triangulated};
use crate::app::fault::Fault;
use crate::app::provenance::{Edit, EditRecord};
use crate::app::repairs::{Mended, mend, preview};
use crate::app::runner::Runner;
use crate::app::{Loaded, Session};
use crate::io::Read;
use crate::remesh::repair::{Weld, is_suspect};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::rc::Rc;

impl Runner {
    /// A document of the surface as it is now, repaired; `None` where there is nothing to repair.
    fn repaired(&self, options: RepairOptions) -> Result<Option<Document>, Fault> {
        let document = self.present();
        if !is_suspect(&document.polygons, &self.x, options.weld) {
            return Ok(None);
        }
        let mesh = &document.polygons;
        let mended = match options.weld {
            Weld::Auto => document.mended.take(mesh, &self.x)?,
            weld => mend(&mesh.to_soup(&self.x), weld)?,
        };
        let Mended { built, items, were } = mended;
        if items.is_empty() {
            return Ok(None);
        }
        let chosen = |list: &Option<Vec<u32>>| {
            let list = list.as_ref()?;
            let mut is_chosen = vec![false; self.x.len()];
            for &v in list {
                if let Some(is_chosen) = is_chosen.get_mut(v as usize) {
                    *is_chosen = true;
                }
            }
            let now = (0..).zip(&were).filter(|(_, v)| is_chosen[**v as usize]);
            Some(now.map(|(v, _)| v).collect())
        };
        let polygons = Rc::new(built.mesh);
        let mut warnings = document.warnings.clone();
        warnings.extend(items.iter().map(|item| item.message.clone()));
        let repaired = Document {
            triangles: triangulated(&polygons, &built.positions)?,
            numbers: document.numbers.plain(&polygons),
            polygons,
            start: built.positions,
            colours: document.colours.carried(&were),
            lineage: Rc::default(),
            free: chosen(&self.options().free),
            fixed: chosen(&self.options().fixed),
            warnings,
            opened: Vec::new(),
            repaired: items,
            ..document
        };
        Ok(Some(repaired.with_shape_warnings()))
    }
}

/// Refusals of a surface that a repair may help against.
const MENDABLE: [&str; 10] = [
    "NotClosed",
    // Of loose triangles all vertices are boundary.
    "NothingFree",
    "NotOriented",
    "NotOrientable",
    "ZeroLengthEdge",
    "Unfit",
    "TouchingLoop",
    "StraightLoop",
    "NoSmallLoops",
    "NoRoom",
];

impl Session {
    /// A refusal with what a repair of the surface would change, where that may help.
    pub(in crate::app) fn offering(&self, mut fault: Fault) -> Fault {
        if let Some(runner) = &self.runner
            && MENDABLE.contains(&fault.kind)
        {
            let present = runner.present();
            fault.repairs = preview(&present.mended, &present.polygons, &present.start).into();
        }
        fault
    }

    /// Repairs the surface as it is now, which becomes the start; where there is nothing to repair
    /// nothing changes. [`undo_edit`](Self::undo_edit) undoes it. What was changed stands in
    /// [`Loaded::repaired`].
    ///
    /// # Errors
    /// [`Fault::no_mesh`]; where no face is left.
    pub fn repair(&mut self, options: RepairOptions) -> Result<Loaded, Fault> {
        match self.runner()?.repaired(options)? {
            Some(document) => self.edit(Edit::Repair(options), |_| Ok((document, ())))?,
            None => self.runner_mut()?.document.repaired.clear(),
        }
        self.loaded()
    }

    /// Loads a mesh file and repairs it; it need not be a surface.
    /// [`undo_edit`](Self::undo_edit) takes the repair of one that is back, and with that of another
    /// the file: what was there before is there again.
    ///
    /// # Errors
    /// As [`load`](Self::load), less what a repair helps against; the mesh loaded before stays.
    pub fn load_repaired(
        &mut self,
        bytes: &[u8],
        file_name: &str,
        options: RepairOptions,
    ) -> Result<Loaded, Fault> {
        let offered = self.offered.take();
        if let Some(Offered { file, read, mended }) = offered
            && options.weld == Weld::Auto
            && file == digest(bytes, file_name)
        {
            self.open_mended(read, mended, file_name, options)?;
            return self.loaded();
        }
        match Opened::of(bytes, file_name)? {
            Opened::Surface(document) => {
                let opened = document.opened.clone();
                self.open(document)?;
                self.repair(options)?;
                let runner = self.runner_mut()?;
                runner.document.repaired.splice(0..0, opened);
            }
            Opened::Broken(read, fault) => {
                // What it is refused for is the reason to repair it.
                let mended = mend(&read.soup, options.weld).map_err(|_| fault)?;
                self.open_mended(read, mended, file_name, options)?;
            }
        }
        self.loaded()
    }

    /// What a file that is no surface is refused with: why, and what a repair would change, which is
    /// kept for when it is asked for.
    pub(in crate::app) fn offer_repair(
        &mut self,
        bytes: &[u8],
        file_name: &str,
        read: Read,
        mut fault: Fault,
    ) -> Fault {
        if let Ok(mended) = mend(&read.soup, Weld::Auto) {
            fault.repairs = mended.items.clone().into();
            self.offered = Some(Offered {
                file: digest(bytes, file_name),
                read,
                mended,
            });
        }
        fault
    }

    fn open_mended(
        &mut self,
        read: Read,
        mended: Mended,
        file_name: &str,
        options: RepairOptions,
    ) -> Result<(), Fault> {
        let document = Document::from_broken(read, mended, file_name)?;
        let before = self.runner.take();
        let arrangement = before.as_ref().map(|runner| runner.arrangement);
        let other_half = std::mem::take(&mut self.other_half);
        self.open(document)?;
        let runner = self.runner_mut()?;
        runner.arrangement = arrangement.unwrap_or_default();
        runner.origin = Some(vec![EditRecord {
            flow: None,
            path: Vec::new(),
            edit: Edit::Repair(options),
        }]);
        // The file as it is cannot be shown: what was shown before it can.
        if let Some(before) = before {
            self.edits.push((before.suspend(), other_half));
        }
        Ok(())
    }
}

/// A file that was refused, and what the usual repair makes of it.
pub(in crate::app) struct Offered {
    file: u64,
    read: Read,
    mended: Mended,
}

fn digest(bytes: &[u8], file_name: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    (bytes, file_name).hash(&mut hasher);
    hasher.finish()
}
