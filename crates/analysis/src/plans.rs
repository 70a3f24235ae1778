//! Plans of a position, reactions by cause and over the cycle, geometry of the contacts.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::results::{Analysis, Column, Cycle, Owner, Part, Quantity, Schema, Survey, Table};
use assur_diagram::{
    DiagramError, Enveloping, Hodograph, PlanSheet, Share, SignChange, Sizes, Solver, constructions,
    enveloping, sheet, sign_changes, split,
};
use assur_force::{AnalyzerPlugin, Construction, LoadState, Loads};
use assur_group::Order;
use assur_kinematics::Position;
use assur_mechanism::{LinkId, Name, Named, PairId, SlideId};
use assur_words::text;
use indexmap::IndexMap;

use crate::Calculation;

/// Most places of the path of a contact.
const MOST_OF_PATH: usize = 3600;
/// A guide whose force stays below this part of the greatest reaction is unloaded: the force is rounding.
const LEAST_FORCE: f64 = 1e-9;

impl Calculation {
    /// All plans of a position in its motion: prescribed, or of the steady regime. In a transient motion, and where no
    /// regime is found, the positions have no forces, and plans of forces are left out.
    ///
    /// Needs the whole mechanism: see [`Plan::is_partial`](crate::plan::Plan::is_partial).
    pub fn sheet(&self, index: usize) -> Result<PlanSheet, DiagramError> {
        // An error names the number of the position.
        self.linkage.solve_index(index, Order::Place, &mut self.linkage.position())?;
        let state = self.state(self.linkage.mechanism.input.coordinate(index));
        self.sheet_in(&state, self.positions_have_forces())
    }

    /// All plans in a state of the motion, of forces where it has some.
    pub fn sheet_in(&self, state: &LoadState, has_forces: bool) -> Result<PlanSheet, DiagramError> {
        // At rest the plans are those for unit speed.
        let moves = state.speed != 0.0 || state.acceleration != 0.0;
        let own;
        let loads = if let Some(loads) = &self.loads {
            loads
        } else {
            own = Loads::compile(&self.linkage)?;
            &own
        };
        let found = sheet(&self.linkage, loads, state, moves, self.reaction_analyzer()?)?;
        if has_forces {
            return Ok(found);
        }
        Ok(PlanSheet { polygons: Vec::new(), constructions: Vec::new(), by_cause: None, ..found })
    }

    /// The constructions on paper of the force analyzers at a position, step by step, each with the name of its analyzer; none where the position has no
    /// forces.
    pub fn constructions(&self, index: usize) -> Result<Vec<(&'static str, Construction)>, DiagramError> {
        let mut position = self.linkage.position();
        self.linkage.solve_index(index, Order::Second, &mut position)?;
        if !self.positions_have_forces() {
            return Ok(Vec::new());
        }
        self.constructions_in(&self.state(position.coordinate))
    }

    /// The same in a state of the motion that has forces.
    pub fn constructions_in(
        &self,
        state: &LoadState,
    ) -> Result<Vec<(&'static str, Construction)>, DiagramError> {
        let mut position = self.linkage.position();
        self.linkage.solve(state.coordinate, Order::Second, &mut position)?;
        let Some(loads) = &self.loads else { return Ok(Vec::new()) };
        constructions(&self.linkage, &position, &loads.acting(state, &position.bodies))
    }

    /// The reactions of all pairs in a state of the motion, and the balancing load; `None` without loads, and where they are not
    /// determined.
    pub fn reactions(&self, state: &LoadState, position: &Position) -> Option<Share> {
        let (loads, analyzer) = (self.loads.as_ref()?, self.reaction_analyzer().ok()?);
        Some(split(&self.linkage, position, loads, state, analyzer.instance).ok()?.whole)
    }

    /// The analyzer of the calculation, where it gives reactions; else the default one.
    fn reaction_analyzer(&self) -> Result<&'static AnalyzerPlugin, DiagramError> {
        match self.analyzer.filter(|analyzer| analyzer.gives_reactions) {
            Some(analyzer) => Ok(analyzer),
            None => Ok(assur_force::choose(None, false, !self.linkage.structure.passive.is_empty())?),
        }
    }

    /// Adds reactions by cause to every position that has reactions, and the polar diagrams of all reactions.
    pub fn add_causes(&self, analysis: &mut Analysis) -> Result<(), DiagramError> {
        let Some(loads) = &self.loads else { return Ok(()) };
        let positions = &mut analysis.positions;
        let Some(reactions) = positions.schema().select(is_force).first().copied() else { return Ok(()) };
        let instance = self.reaction_analyzer()?.instance;
        let mut solved = self.linkage.position();
        let mut shares = Shares::new(positions);
        for (row, &index) in positions.numbers().iter().enumerate() {
            if positions.at(row, reactions).is_none() {
                continue;
            }
            let state = self.state(self.linkage.mechanism.input.coordinate(index));
            self.linkage.solve_index(index, Order::Second, &mut solved)?;
            shares.add(index, &split(&self.linkage, &solved, loads, &state, instance)?.shares);
        }
        positions.join(&shares.table(Schema::new(&self.linkage.mechanism)));
        analysis.cycle.hodographs = self.hodographs(positions);
        Ok(())
    }

    /// Results from the reactions of all positions, and the geometry of the contacts.
    pub(crate) fn cycle(&self, survey: &Survey) -> Cycle {
        let mechanism = &self.linkage.mechanism;
        let input = &mechanism.input;
        let extreme = |(pair, link, sizes): &(PairId, LinkId, Sizes)| {
            let places = (|index| input.coordinate(index), input.is_cycle());
            sizes.extreme(mechanism.named_pair(*pair), mechanism.named_link(*link), places)
        };
        Cycle {
            reaction_extremes: survey.sizes.iter().filter_map(extreme).collect(),
            sign_changes: self.sign_changes(survey),
            enveloping: self.enveloping(),
            ..Cycle::default()
        }
    }

    /// The polar diagrams of all reactions, over the positions that have them.
    fn hodographs(&self, positions: &Table) -> Vec<Hodograph> {
        let schema = positions.schema();
        let Some(coordinate) = schema.find(Column::COORDINATE) else { return Vec::new() };
        let curve = |x: usize| {
            let Owner::PairOn(pair, link) = schema.columns()[x].owner else { return None };
            let row = |((x, y), coordinate): ((Option<f64>, Option<f64>), Option<f64>)| {
                Some((coordinate?, [x?, y?]))
            };
            let rows = positions.each(x).zip(positions.each(x + 1)).zip(positions.each(coordinate));
            let (coordinates, points): (Vec<_>, Vec<_>) = rows.filter_map(row).unzip();
            let mechanism = &self.linkage.mechanism;
            let (joint, on) = (mechanism.named_pair(pair), mechanism.named_link(link));
            let closed = mechanism.input.is_cycle();
            (!points.is_empty()).then_some(Hodograph { joint, on, coordinates, points, closed })
        };
        schema.select(is_force).into_iter().filter_map(curve).collect()
    }

    /// A contact whose arc has no position somewhere in its interval is left out: the failures of the positions say
    /// why.
    fn enveloping(&self) -> Vec<Enveloping> {
        if self.plan.is_partial() {
            return Vec::new();
        }
        let mechanism = &self.linkage.mechanism;
        let count = mechanism.input.positions.min(MOST_OF_PATH);
        let each = mechanism.loads.iter().filter_map(|load| {
            let contact = load.kind.contact()?;
            enveloping(&self.linkage, &load.name, contact, count).ok()
        });
        each.collect()
    }

    /// Of the guides with a force; none where a position is missing, because the force is unknown there.
    fn sign_changes(&self, survey: &Survey) -> IndexMap<Named<SlideId>, Vec<SignChange>> {
        let (Some(loads), Ok(analyzer)) = (&self.loads, self.reaction_analyzer()) else {
            return IndexMap::new();
        };
        let state_at = |coordinate: f64| self.state(coordinate);
        let least = LEAST_FORCE * greatest(survey, |_| true);
        let slides = self.plan.wanted.reactions.iter().filter_map(|pair| match pair {
            PairId::Slide(slide) if greatest(survey, |of| of == *pair) > least => Some(*slide),
            _ => None,
        });
        let slides: Vec<SlideId> = slides.collect();
        if slides.is_empty() {
            return IndexMap::new();
        }
        let solver = Solver {
            linkage: &self.linkage,
            loads,
            analyzer: analyzer.instance,
            order: self.plan.order,
            carrying: &self.plan.groups_carrying,
        };
        let changes = sign_changes(&solver, &slides, &state_at).unwrap_or_default();
        let name = |slide| self.linkage.mechanism.named_slide(slide);
        slides.into_iter().map(name).zip(changes).collect()
    }
}

/// Whether a column is the projection on the x axis of a force under all loads; the column after it is the other
/// projection.
fn is_force(column: &Column) -> bool {
    column.quantity == Quantity::Force && column.part == Part::X && column.cause.is_none()
}

/// Greatest force in some pairs, N.
fn greatest(survey: &Survey, wanted: impl Fn(PairId) -> bool) -> f64 {
    let pairs = survey.sizes.iter().filter(|(pair, ..)| wanted(*pair));
    pairs.map(|(.., sizes)| sizes.greatest()).fold(0.0, f64::max)
}

/// The shares of single causes in the reactions of some positions.
struct Shares {
    /// Owners of the forces and moments, in the order of the reactions.
    wanted: Vec<(Column, PairId, Option<LinkId>)>,
    /// The balancing loads.
    balancing: Vec<Column>,
    causes: Vec<Name>,
    /// The number of a position, and by cause its numbers: the wanted ones, then the balancing loads.
    rows: Vec<(usize, BTreeMap<usize, Vec<f64>>)>,
}

impl Shares {
    fn new(positions: &Table) -> Self {
        let wanted = positions.schema().columns().iter();
        let wanted = wanted.filter_map(|column| match (column.quantity, column.owner) {
            (Quantity::Force, Owner::PairOn(pair, link)) => Some((*column, pair, Some(link))),
            (Quantity::Moment, Owner::Pair(pair)) => Some((*column, pair, None)),
            _ => None,
        });
        let balances = |column: &&Column| column.quantity == Quantity::Balancing && column.cause.is_none();
        let balancing = positions.schema().columns().iter().filter(balances).copied().collect();
        Self { wanted: wanted.collect(), balancing, causes: Vec::new(), rows: Vec::new() }
    }

    fn add(&mut self, number: usize, shares: &[Share]) {
        let mut row = BTreeMap::new();
        for share in shares {
            let mut name = Name::from(share.cause.clone());
            // A load may be called `weight` too.
            let cause = loop {
                let known = self.causes.iter().position(|known| *known == name);
                let cause = known.unwrap_or(self.causes.len());
                if !row.contains_key(&cause) {
                    break cause;
                }
                name = text!("analysis-load-named", name).into();
            };
            if cause == self.causes.len() {
                self.causes.push(name);
            }
            let value = |(column, pair, on): &(Column, PairId, Option<LinkId>)| {
                let mut of_pair = share.reactions.iter().filter(|reaction| reaction.joint.id == *pair);
                let value = match on {
                    Some(on) => of_pair
                        .find(|reaction| reaction.on.id == *on)
                        .map(|reaction| reaction.force[usize::from(column.part == Part::Y)]),
                    None => of_pair.find_map(|reaction| reaction.moment),
                };
                value.unwrap_or(0.0)
            };
            let loads = self.balancing.iter().zip(share.balancing_loads());
            row.insert(cause, self.wanted.iter().map(value).chain(loads.map(|(_, load)| *load)).collect());
        }
        self.rows.push((number, row));
    }

    /// Their columns under the schema of the positions.
    fn table(self, mut schema: Schema) -> Table {
        schema.causes = self.causes;
        for cause in 0..schema.causes.len() {
            let section = schema.section();
            let forces = self.wanted.iter().map(|(column, ..)| column).chain(&self.balancing);
            schema.add(section, forces.map(|column| Column { cause: Some(cause), ..*column }));
        }
        let (causes, count) = (schema.causes.len(), self.wanted.len() + self.balancing.len());
        let mut table = Table::new(Arc::new(schema));
        for (number, row) in self.rows {
            let of = |cause| (0..count).map(move |column| (cause, column));
            table
                .push(number, (0..causes).flat_map(of).map(|(cause, column)| Some(row.get(&cause)?[column])));
        }
        table
    }
}
