//! What is looked for by its name: reactions, plans, quantities, rows of a list. `told` makes words of a text.

use assur_words::Text;

use crate::{Found, Look, Picture, Plans, Reaction, Results, ViewPart};

impl Look<'_> {
    /// Chooses what a part of a picture shows by its name, the next one behind what is chosen now; `None` if there is nothing of this
    /// name.
    pub fn choose(
        &mut self,
        results: &Results,
        (picture, part): (Picture, ViewPart),
        sought: &str,
        told: impl Fn(&Text) -> String,
    ) -> Option<()> {
        let (found, wanted) = (results.found.as_deref(), sought.to_lowercase());
        let plans = || Some(found?.plans.at(self.position));
        match (picture, part) {
            (Picture::Forces, _) => self.reaction = reaction(found?, self.reaction, &wanted)?,
            (Picture::Plans, ViewPart::Construction) => self.step = step(&*plans()?, &wanted, told)?,
            (Picture::Plans, ViewPart::Forces) => self.polygon = polygon(&*plans()?, &wanted, told)?,
            (Picture::Plans, _) => return None,
            (Picture::Structure, _) => {
                let names: Vec<String> = results.group_names().iter().map(told).collect();
                self.group = row(&names, self.group, sought)?;
            }
            _ => {
                self.column = column(results, self.column, &wanted, told)?;
                self.transfer = results.transfer_of(self.column).unwrap_or(self.transfer);
            }
        }
        Some(())
    }
}

/// The first of so many items that fits, of those after the present one and then of those up to it.
pub fn next(now: usize, count: usize, fits: impl Fn(usize) -> bool) -> Option<usize> {
    (1..=count).map(|step| (now + step) % count).find(|index| fits(*index))
}

/// The next reaction of a pair of this name, else one whose pair or link begins with it.
fn reaction(found: &Found, now: usize, wanted: &str) -> Option<usize> {
    let names = |reaction: &Reaction| {
        reaction.of.as_ref().map(|(pair, link)| [pair.to_lowercase(), link.to_lowercase()])
    };
    let after = |fits: &dyn Fn(&[String; 2]) -> bool| {
        next(now, found.reactions.len(), |index| names(&found.reactions[index]).as_ref().is_some_and(fits))
    };
    after(&|[pair, _]| pair == wanted)
        .or_else(|| after(&|names| names.iter().any(|name| name.starts_with(wanted))))
}

/// The last step of the construction of a force analyzer.
fn step(plans: &Plans, wanted: &str, told: impl Fn(&Text) -> String) -> Option<usize> {
    let same = plans.constructions.iter().position(|(method, _)| *method == wanted);
    let mut all = plans.constructions.iter();
    plans.steps_of(same.or_else(|| all.position(|(_, drawn)| contains(&told(&drawn.title), wanted)))?).last()
}

/// The force polygon of a group.
fn polygon(plans: &Plans, wanted: &str, told: impl Fn(&Text) -> String) -> Option<usize> {
    let polygons = plans.sheet.as_ref().map_or(&[][..], |sheet| &sheet.polygons);
    polygons.iter().position(|polygon| contains(&told(&polygon.title), wanted))
}

fn contains(text: &str, wanted: &str) -> bool {
    text.to_lowercase().contains(wanted)
}

/// The quantity of a name: the one with just this name, or else the next one in whose name it occurs.
fn column(results: &Results, now: usize, wanted: &str, told: impl Fn(&Text) -> String) -> Option<usize> {
    let names = |column: usize| {
        let series = results.column(column)?;
        let names = [told(&series.of), told(&series.head), series.short.clone()];
        Some(names.map(|name| name.to_lowercase()))
    };
    let after = |fits: &dyn Fn(&String) -> bool| {
        let fits = |column| names(column).is_some_and(|names| names.iter().any(fits));
        next(now, results.column_count(), fits)
    };
    after(&|name| name == wanted).or_else(|| after(&|name| name.contains(wanted)))
}

/// The next row behind `now` in which a text occurs as a word of its own, written alike; else as a word; else anywhere.
pub fn row(rows: &[String], now: usize, wanted: &str) -> Option<usize> {
    let lower = wanted.to_lowercase();
    let is_word = |row: &str, wanted: &str| {
        let mut places = row.match_indices(wanted);
        places.any(|(at, _)| {
            let (before, after) = (&row[..at], &row[at + wanted.len()..]);
            !before.ends_with(char::is_alphanumeric) && !after.starts_with(char::is_alphanumeric)
        })
    };
    let fits: [&dyn Fn(&str) -> bool; 3] =
        [&|row| is_word(row, wanted), &|row| is_word(&row.to_lowercase(), &lower), &|row| {
            row.to_lowercase().contains(&lower)
        }];
    fits.iter().find_map(|fits| next(now, rows.len(), |row| fits(&rows[row])))
}
