//! The kind RRR with one mistake each.

use assur_group::PairSort::Pin;
use assur_group::{
    Assemblies, AssurGroup, Body, BuildError, Builders, Closed, ForceAngle, GroupError, GroupFrame,
    GroupKind, GroupPlugin, Number, Order, Pattern, Wrench, inventory,
};
use assur_group_rrr::Rrr;
use assur_number::Real;

const NONE: u8 = 0;
const PLACE: u8 = 1;
const MOVES: u8 = 2;
const HEALTH: u8 = 3;
const SURE: u8 = 4;
const GAP: u8 = 5;
const NAN: u8 = 6;
const FIRST: u8 = 7;
const SECOND: u8 = 8;
const SOLVE: u8 = 9;
const REACTION: u8 = 10;
const OUTER: u8 = 11;
const ROUNDED: u8 = 12;

#[derive(Debug)]
struct Faulty<T, const MISTAKE: u8>(Closed<Rrr<T>>);

impl<T: Real, const MISTAKE: u8> AssurGroup<T> for Faulty<T, MISTAKE> {
    fn frame(&self) -> &GroupFrame {
        self.0.frame()
    }

    fn ways(&self) -> usize {
        2
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        let link = self.frame().links[0];
        let health = match self.0.place(bodies, way) {
            Err(GroupError::NoAssembly { gap_m }) if MISTAKE == GAP => {
                return Err(GroupError::NoAssembly { gap_m: 1.01 * gap_m });
            }
            Err(GroupError::Singular { health }) if MISTAKE == NAN && health.is_nan() => T::ONE,
            other => other?,
        };
        match MISTAKE {
            PLACE => bodies[link].x += T::from_f64(1e-9),
            MOVES => bodies[2].x1 += T::ONE,
            ROUNDED => bodies[link].x = T::from_f64(bodies[link].x.to_f64()),
            _ => {}
        }
        Ok(if MISTAKE == SURE { health + T::from_f64(1e-3) } else { health })
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        let link = self.frame().links[0];
        match self.0.derive(bodies, order) {
            Err(GroupError::Singular { health }) if MISTAKE == NAN && health.is_nan() => {}
            other => other?,
        }
        match MISTAKE {
            FIRST => bodies[link].y1 += T::from_f64(1e-9),
            SECOND => bodies[link].w2 += T::from_f64(1e-9),
            _ => {}
        }
        Ok(())
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let health = self.place(bodies, way)?;
        self.derive(bodies, if MISTAKE == SOLVE { Order::First } else { order })?;
        Ok(health)
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        match MISTAKE {
            HEALTH => 0.5 * self.0.health(bodies),
            SURE => self.0.health(bodies) + 1e-3,
            _ => self.0.health(bodies),
        }
    }

    fn reactions_under(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
        sets: usize,
    ) -> Result<(), GroupError> {
        self.0.reactions_under(bodies, loads, reactions, sets)?;
        let outer = self.frame().outer[0];
        match MISTAKE {
            REACTION => reactions[self.frame().inner[0].id].fx += T::from_f64(1e-8),
            OUTER if self.frame().column(outer.a).is_none() => loads[outer.a].m += T::from_f64(1e-8),
            OUTER => loads[outer.b].m += T::from_f64(1e-8),
            _ => {}
        }
        Ok(())
    }
}

struct Kind<const MISTAKE: u8>;

impl<const MISTAKE: u8> GroupKind for Kind<MISTAKE> {
    type Kernel<T: Number> = Faulty<T, MISTAKE>;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Faulty<T, MISTAKE>, BuildError> {
        Closed::new(frame).map(Faulty)
    }
}

/// The words of an entry of a test.
const TEST: assur_words::Text = assur_words::Text::message("a test", Vec::new());

macro_rules! faulty {
    ($($name:literal: $mistake:ident),*) => {$(
        inventory::submit! {
            GroupPlugin {
                name: $name,
                kind: "RRR",
                number: 1,
                crate_name: env!("CARGO_PKG_NAME"),
                summary: TEST,
                pattern: Some(Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Pin)] }),
                rank: 10,
                ways: Assemblies { most: 2, varies: false, words: TEST },
                iterates: false,
                singular: TEST,
                force_angle: ForceAngle::DEFAULT,
                source: TEST,
                builders: Builders::of::<Kind<$mistake>>(),
            }
        }
    )*};
}
faulty!(
    "faulty-none": NONE, "faulty-place": PLACE, "faulty-moves": MOVES, "faulty-health": HEALTH, "faulty-sure": SURE,
    "faulty-gap": GAP, "faulty-nan": NAN, "faulty-first": FIRST, "faulty-second": SECOND, "faulty-solve": SOLVE,
    "faulty-reaction": REACTION, "faulty-outer": OUTER, "faulty-rounded": ROUNDED
);
