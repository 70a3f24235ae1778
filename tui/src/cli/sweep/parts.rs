//! Rows as Parquet: in parts in a folder beside the file, which are joined when all are there.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use assur_parquet::ParquetError;
use assur_parquet::sweep::{self as parquet, FilePart};
use assur_sweep::{Origin, Rows, Tally};
use assur_words::{Describe, text};

use super::Job;
use super::target::Unfinished;
use crate::cli::fault::{Fault, Status};
use crate::files;

pub(super) fn run(job: &Job<'_>, path: &Path, resume: bool) -> Result<(Status, Tally), Fault> {
    let unfinished = Unfinished::of(path, resume, job.style)?;
    let rows = job.sweep.rows_of_part(job.points.len());
    let opened = opened(&unfinished)?;
    let folder = Folder { unfinished: &unfinished, opened, rows, origin: job.origin() };
    let mut all = folder.found(job)?;
    let mut parts = all.points().div_ceil(folder.rows);
    let mut collected: Option<Rows> = None;
    let total = job.points.len();
    job.run(all.points(), Ok, |rows, tally| {
        all.append(&tally);
        let mut group = match collected.take() {
            Some(mut group) => {
                group.append(rows);
                group
            }
            None => rows,
        };
        // Blocks may reach over the end of a part.
        while group.len() >= folder.rows || all.points() == total && !group.is_empty() {
            let rest = group.split_off(folder.rows.min(group.len()));
            folder.write(parts, &group)?;
            parts += 1;
            group = rest;
        }
        collected = Some(group).filter(|group| !group.is_empty());
        Ok(())
    })?;
    if let Err(hopeless) = job.refuse_hopeless(&all) {
        folder.remove()?;
        return Err(hopeless);
    }
    let status = job.tell_failures(&all);
    unfinished.refuse_partial(status)?;
    unfinished.put(&folder.joined(job, parts)?)?;
    folder.remove()?;
    Ok((status, all))
}

/// The folder, made unless an earlier run has; a link to another folder is not followed.
fn opened(unfinished: &Unfinished<'_>) -> Result<File, Fault> {
    let path = &unfinished.path;
    match fs::create_dir(path) {
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => match fs::symlink_metadata(path) {
            Ok(found) if found.is_dir() => {}
            _ => return Err(unfinished.refused(text!("file-no-parts"))),
        },
        created => created.map_err(|error| unfinished.fault(error))?,
    }
    File::open(path).map_err(|error| unfinished.fault(error))
}

struct Folder<'a> {
    unfinished: &'a Unfinished<'a>,
    /// As it was when the sweep began.
    opened: File,
    rows: usize,
    origin: Origin,
}

impl Folder<'_> {
    fn part(&self, index: usize) -> PathBuf {
        self.unfinished.path.join(format!("{index:06}.parquet"))
    }

    /// The name of a file that is not complete.
    fn next(&self) -> PathBuf {
        self.unfinished.path.join("next")
    }

    #[expect(clippy::needless_pass_by_value, reason = "takes errors as `map_err` hands them over")]
    fn unwritten(&self, problem: ParquetError) -> Fault {
        self.unfinished.refused(problem.describe())
    }

    /// Writes a part; it has its name only when it is complete.
    fn write(&self, index: usize, rows: &Rows) -> Result<(), Fault> {
        let bytes = parquet::part(rows, &self.origin).map_err(|error| self.unwritten(error))?;
        self.unfinished.keep(&self.opened)?;
        let written = files::create_own(&self.next()).and_then(|mut next| next.write_all(&bytes));
        let put = written.and_then(|()| fs::rename(self.next(), self.part(index)));
        put.map_err(|error| self.unfinished.fault(error))
    }

    fn found(&self, job: &Job<'_>) -> Result<Tally, Fault> {
        let mut all = Tally::default();
        for index in 0.. {
            let file = match File::open(self.part(index)) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => break,
                file => file.map_err(|error| self.unfinished.fault(error))?,
            };
            let left = job.points.len().saturating_sub(all.points());
            let foreign = || self.unfinished.foreign(all.points() + 1);
            let part = FilePart::read(&file, job.sweep).ok_or_else(foreign)?;
            self.unfinished.compare(&part.origin, &self.origin)?;
            if part.tally.points() != left.min(self.rows) {
                return Err(foreign());
            }
            all.append(&part.tally);
            if parquet::last(&job.sweep.row(job.points.start + all.points() - 1)) != part.last {
                return Err(self.unfinished.foreign(all.points()));
            }
            if let Some((best, column)) = &job.judge {
                let found = parquet::best(file, &job.sweep.columns, (best, *column));
                job.judge(found.map_err(|error| self.unwritten(error))?);
            }
        }
        Ok(all)
    }

    fn joined(&self, job: &Job<'_>, parts: usize) -> Result<PathBuf, Fault> {
        self.unfinished.keep(&self.opened)?;
        let out = files::create_own(&self.next()).map_err(|error| self.unfinished.fault(error))?;
        let files = (0..parts).map(|index| File::open(self.part(index)));
        parquet::join(job.sweep, &self.origin, files, &out).map_err(|error| self.unwritten(error))?;
        out.sync_all().map_err(|error| self.unfinished.fault(error))?;
        Ok(self.next())
    }

    fn remove(&self) -> Result<(), Fault> {
        fs::remove_dir_all(&self.unfinished.path).map_err(|error| self.unfinished.fault(error))
    }
}
