//! The fields of a sheet: pictures of the results.

use assur_figure::{Figure, Item, Panel};
use assur_mechanism::LinkId;
use assur_picture::paper::on_paper;
use assur_picture::{Found, Look, Results, ViewPart, assembly, curves, motion, plans, polygons, regime};
use assur_scene::{Note, SheetField, SheetPositions};
use assur_words::{Language, Text, joined, list, number, text};

use crate::drawn::{Content, Drawn, titled};
use crate::wanted;

/// What all fields are drawn of.
pub(crate) struct Source<'a> {
    pub(crate) results: &'a Results,
    pub(crate) found: &'a Found,
    pub(crate) note: &'a Note,
    pub(crate) language: &'a Language,
    /// The same with the numbers of links.
    pub(crate) numbered: &'a Language,
    /// The positions of plans and polygons, at least one.
    pub(crate) plans: Vec<usize>,
}

/// Least widths, mm, and weights: of the mechanism, of plots, of a plan, of links with what acts on them, of a plan of
/// accelerations with its components, of a lever, of a panel of the structure.
const MECHANISM: (f64, f64) = (150.0, 4.0);
const PLOTS: (f64, f64) = (100.0, 2.5);
const PLAN: (f64, f64) = (75.0, 1.0);
const LOADED: (f64, f64) = (90.0, 1.2);
const ACCELERATIONS: (f64, f64) = (95.0, 1.5);
const LEVER: (f64, f64) = (100.0, 1.5);
const STRUCTURE: (f64, f64) = (110.0, 1.2);

impl Source<'_> {
    /// The blocks of all fields that are wanted, in their order.
    pub(crate) fn blocks(&self) -> Vec<Drawn> {
        wanted(self.note).into_iter().flat_map(|field| self.field(field)).collect()
    }

    fn field(&self, field: SheetField) -> Vec<Drawn> {
        let (results, first) = (self.results, look(self.plans[0]));
        match field {
            SheetField::Mechanism => {
                let all = assembly::positions(results, &self.positions(), self.plans[0]);
                let mut drawn =
                    Self::figures(field, MECHANISM, [titled_first(all, text!("sheet-positions"))]);
                drawn.extend(Self::figures(field, STRUCTURE, [assembly::groups(results, self.plans[0])]));
                drawn
            }
            SheetField::Diagrams => Self::figures(field, PLOTS, [curves::of_last(results, &first)]),
            SheetField::Velocities => {
                self.of_positions(field, PLAN, ("sheet-velocities", ViewPart::Velocities))
            }
            SheetField::Accelerations => {
                self.of_positions(field, ACCELERATIONS, ("sheet-accelerations", ViewPart::Accelerations))
            }
            SheetField::Forces => self.forces(),
            SheetField::Lever => self.lever(),
            SheetField::Dynamics => self.dynamics(&first),
            SheetField::Results => vec![self.table_of_results()],
        }
    }

    fn at(&self, id: &'static str, position: usize) -> Text {
        Text::message(id, vec![("place", self.place(position))])
    }

    /// Where a position is, without its coordinate: the numbers of positions stand at the mechanism.
    pub(crate) fn place(&self, position: usize) -> Text {
        match self.results.time(position) {
            Some(time) => text!("sheet-instant", instant = number(position), time),
            None => text!("sheet-position", position = number(position)),
        }
    }

    /// What there is of these figures.
    fn figures(
        field: SheetField,
        (least, weight): (f64, f64),
        all: impl IntoIterator<Item = Figure>,
    ) -> Vec<Drawn> {
        let has_numbers =
            !matches!(field, SheetField::Mechanism | SheetField::Diagrams | SheetField::Dynamics);
        let drawn = |figure| {
            let content = Content::Figure(on_paper(figure));
            Drawn { field, content, weight, least, has_numbers }
        };
        all.into_iter().filter(|figure| !figure.panels.is_empty()).map(drawn).collect()
    }

    /// The positions that are drawn over each other.
    fn positions(&self) -> Vec<usize> {
        let count = self.results.positions();
        match &self.note.sheet.positions {
            SheetPositions::Numbers(numbers) => numbers.clone(),
            SheetPositions::Count(wanted) => {
                let wanted = (*wanted).clamp(1, count);
                (0..wanted).map(|index| index * count / wanted).collect()
            }
        }
    }

    fn of_positions(
        &self,
        field: SheetField,
        size: (f64, f64),
        (id, part): (&'static str, ViewPart),
    ) -> Vec<Drawn> {
        let plan = |position: &usize| {
            let figure = plans::figure(self.results, &look(*position), part);
            // What the vectors are, their points say.
            Figure { legend: Vec::new(), ..titled_first(figure, self.at(id, *position)) }
        };
        Self::figures(field, size, self.plans.iter().map(plan).collect::<Vec<_>>())
    }

    /// Of each position the groups with what acts on them and their polygons, from the last to the first, the input link as the last.
    fn forces(&self) -> Vec<Drawn> {
        let (mechanism, bodies) = (&self.results.linkage.mechanism, polygons::bodies(self.results));
        let named = |links: &[LinkId]| {
            let names = list(links.iter().map(|link| Text::from(&mechanism.links[*link].name)));
            text!("sheet-links", count = links.len(), links = names)
        };
        let mut all = Vec::new();
        for &position in &self.plans {
            let plans = self.found.plans.at(position);
            let Ok(sheet) = &plans.sheet else { continue };
            for (polygon, links) in bodies.iter().enumerate().take(sheet.polygons.len()) {
                let drawn = polygons::polygon(self.results, position, polygon, links);
                if drawn.panels.is_empty() {
                    continue;
                }
                let loaded = assembly::loaded(self.results, position, links);
                let [of, place] = [named(links), self.place(position)];
                let loaded = titled_first(loaded, text!("sheet-loaded", of = &of, place = &place));
                let drawn = titled_first(drawn, text!("sheet-polygon", of, place));
                all.extend(Self::figures(SheetField::Forces, LOADED, [loaded]));
                all.extend(Self::figures(SheetField::Forces, PLAN, [drawn]));
            }
        }
        let table = self.table_of_forces(&bodies).filter(|_| !all.is_empty());
        table.into_iter().chain(all).collect()
    }

    /// Zhukovsky's lever of each position, and its forces with their arms.
    fn lever(&self) -> Vec<Drawn> {
        let lever = |position: &usize| {
            let figure = plans::lever(self.results, &look(*position));
            titled_first(figure, self.at("sheet-lever", *position))
        };
        let drawn = Self::figures(SheetField::Lever, LEVER, self.plans.iter().map(lever).collect::<Vec<_>>());
        drawn.into_iter().chain(self.table_of_lever()).collect()
    }

    fn dynamics(&self, look: &Look<'_>) -> Vec<Drawn> {
        let (results, field) = (self.results, SheetField::Dynamics);
        let has_regime = self.found.analysis.dynamics.is_some();
        if !has_regime {
            let mut figure = motion::figure(results, look, ViewPart::Overview, usize::MAX);
            figure.panels.retain(|panel| !is_zero(panel));
            return Self::figures(field, PLOTS, [figure]);
        }
        let drive = |part| regime::drive(results, look, part, 1);
        // The last panel repeats the moments.
        let mut characteristic = drive(ViewPart::Curves);
        characteristic.panels.pop();
        let course = motion::figure(results, look, ViewPart::Course, usize::MAX);
        let mut drawn =
            Self::figures(field, PLOTS, [course, regime::shares_on_paper(results, look), characteristic]);
        drawn.extend(Self::figures(field, PLOTS, [drive(ViewPart::EnergyMass)]));
        drawn
    }
}

fn look(position: usize) -> Look<'static> {
    Look { position, alone: true, ..Look::default() }
}

/// A figure whose first panel has this heading.
fn titled_first(mut figure: Figure, title: Text) -> Figure {
    if figure.panels.len() == 1 {
        let legend = figure.legend;
        return match figure.panels.pop() {
            Some(panel) => Figure { legend, ..titled(panel, title) },
            None => Figure::default(),
        };
    }
    if let Some(panel) = figure.panels.first_mut() {
        panel.title = joined("  ", [title, panel.title.clone()]);
    }
    figure
}

/// Whether all curves of a panel are zero, and show nothing.
fn is_zero(panel: &Panel) -> bool {
    panel.items.iter().flat_map(Item::points).all(|[_, y]| y == 0.0 || !y.is_finite())
}
