//! Rows as lines of CSV: to standard output, to a device, or to a file.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::Path;

use assur_sweep::{Best, ReadRow, Tally};

use super::Job;
use super::target::Unfinished;
use crate::cli::fault::{Fault, Status};
use crate::files;

/// Rows of points none of which can be calculated are held back up to this size: if all are like that, nothing is
/// written.
const HELD: usize = 1 << 20;

/// Longest line that is read back; a row has some tens of bytes for each of at most some million columns.
const LONGEST: u64 = 1 << 28;

pub(super) fn run(job: &Job<'_>, path: Option<&Path>, resume: bool) -> Result<(Status, Tally), Fault> {
    match path.map(|path| (path, files::open_stream(path))) {
        None => stream(job, &mut io::stdout().lock()),
        Some((path, Some(opened))) => {
            let mut out = opened.map_err(|error| files::FileError::write(path, error))?;
            stream(job, &mut out)
        }
        Some((path, None)) => file(job, &Unfinished::of(path, resume, job.style)?),
    }
}

fn header(job: &Job<'_>) -> Result<String, Fault> {
    if job.is_first {
        assur_report::csv::header(&job.sweep.columns.names, job.style.ascii_data).map_err(Fault::told)
    } else {
        Ok(String::new())
    }
}

/// Calculates the points from `done` on and writes their rows.
fn rows(
    job: &Job<'_>,
    done: usize,
    mut write: impl FnMut(&str, Tally) -> Result<(), Fault>,
) -> Result<(), Fault> {
    let encode = |rows: assur_sweep::Rows| rows.to_csv(job.style.ascii_data).map_err(Fault::told);
    job.run(done, encode, |text, tally| write(&text, tally))
}

/// Writes to a stream, which can't be taken back.
fn stream(job: &Job<'_>, out: &mut impl Write) -> Result<(Status, Tally), Fault> {
    let mut all = Tally::default();
    let mut held = header(job)?;
    rows(job, 0, |text, tally| {
        all.append(&tally);
        held.push_str(text);
        if all.is_hopeless() && held.len() < HELD {
            return Ok(());
        }
        let written = out.write_all(held.as_bytes()).and_then(|()| out.flush());
        held.clear();
        written.map_err(Fault::stdout)
    })?;
    job.refuse_hopeless(&all)?;
    out.write_all(held.as_bytes()).and_then(|()| out.flush()).map_err(Fault::stdout)?;
    Ok((job.tell_failures(&all), all))
}

fn file(job: &Job<'_>, unfinished: &Unfinished<'_>) -> Result<(Status, Tally), Fault> {
    let fault = |error: io::Error| unfinished.fault(error);
    let path = &unfinished.path;
    let mut out = files::open_own(path).map_err(fault)?;
    let origin = job.origin();
    if out.metadata().map_err(fault)?.len() > 0 {
        unfinished.compare_said(&origin)?;
    }
    let (mut all, length) = found(job, &out, unfinished)?;
    unfinished.say(&origin)?;
    out.set_len(length).and_then(|()| out.seek(SeekFrom::End(0))).map_err(fault)?;
    if length == 0 {
        out.write_all(header(job)?.as_bytes()).map_err(fault)?;
    }
    rows(job, all.points(), |text, tally| {
        all.append(&tally);
        out.write_all(text.as_bytes()).map_err(fault)
    })?;
    out.sync_all().map_err(fault)?;
    unfinished.keep(&out)?;
    if let Err(hopeless) = job.refuse_hopeless(&all) {
        unfinished.remove()?;
        return Err(hopeless);
    }
    let status = job.tell_failures(&all);
    unfinished.refuse_partial(status)?;
    unfinished.put(path)?;
    Ok((status, all))
}

/// The rows that an earlier run wrote, and the length of the file up to the last whole one: the file holds a beginning
/// of what the sweep writes, because it is only ever appended to.
fn found(job: &Job<'_>, file: &File, unfinished: &Unfinished<'_>) -> Result<(Tally, u64), Fault> {
    let mut lines = BufReader::new(file);
    let (mut all, mut length) = (Tally::default(), 0);
    // Bytes, since the end may be within a character.
    let (mut line, mut last) = (Vec::new(), Vec::new());
    let header = header(job)?;
    loop {
        line.clear();
        let read = lines.by_ref().take(LONGEST).read_until(b'\n', &mut line);
        let read = read.map_err(|error| unfinished.fault(error))?;
        if !line.ends_with(b"\n") {
            break;
        }
        if length == 0 && !header.is_empty() {
            if line != header.as_bytes() {
                return Err(unfinished.foreign(0));
            }
        } else {
            let next = job.points.start + all.points();
            let row = read_row(job, next, &line).ok_or_else(|| unfinished.foreign(all.written + 1))?;
            all.add_read(next, &row);
            job.judge(Best::judged(&row));
            std::mem::swap(&mut line, &mut last);
        }
        length += read as u64;
    }
    let row = |point| job.sweep.row(point).to_csv(job.style.ascii_data).map_err(Fault::told);
    let is_ours = if all.written > 0 {
        row(job.points.start + all.points() - 1)?.as_bytes() == last
    } else if length > 0 || line.is_empty() {
        true
    } else if job.is_first {
        // Nothing whole is here, so what is here must be what the sweep begins with.
        header.as_bytes().starts_with(&line)
    } else {
        match begun(job, &line) {
            Begun::Row(point) => row(point)?.as_bytes().starts_with(&line),
            Begun::Number => true,
            Begun::Nothing => false,
        }
    };
    if is_ours { Ok((all, length)) } else { Err(unfinished.foreign(all.written)) }
}

/// A row that an earlier run wrote: of the point that is next, or where conditions leave points out of a later one.
fn read_row(job: &Job<'_>, next: usize, line: &[u8]) -> Option<ReadRow> {
    let column = job.judge.as_ref().map(|(_, column)| *column);
    let text = str::from_utf8(line).ok()?.trim_end_matches(['\r', '\n']);
    let row = job.sweep.read_row(text, column)?;
    let is_next = row.point == next || row.point > next && job.sweep.has_conditions();
    (is_next && row.point < job.points.end).then_some(row)
}

/// What the only line of a file is, whose end is missing.
enum Begun {
    /// The row of this point.
    Row(usize),
    /// Digits of the number of a point.
    Number,
    Nothing,
}

/// What the beginning of the first row may be: where conditions leave points out, it tells its point itself.
fn begun(job: &Job<'_>, line: &[u8]) -> Begun {
    let point = || str::from_utf8(line).ok()?.split_once(',')?.0.parse().ok();
    let own = |point: &usize| job.points.contains(point);
    if !job.sweep.has_conditions() {
        return Some(job.points.start).filter(own).map_or(Begun::Nothing, Begun::Row);
    }
    match point().filter(own) {
        Some(point) => Begun::Row(point),
        None if line.iter().all(u8::is_ascii_digit) => Begun::Number,
        None => Begun::Nothing,
    }
}
