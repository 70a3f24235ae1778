//! A drawing: what all formats have in common, at its places in the plane, in SI.

use assur_words::{Text, name, text};

/// Most links and joints; nobody draws so many.
const MOST: usize = 2000;

/// A drawing of another program.
#[derive(Debug, Clone, Default)]
pub struct Drawing {
    /// What it is called; may be empty.
    pub title: String,
    /// The joints; a joint of several links is a pin.
    pub joints: Vec<Joint>,
    /// The moving links.
    pub links: Vec<Link>,
    /// The prismatic pairs.
    pub slides: Vec<Slide>,
    /// What drives.
    pub inputs: Vec<Input>,
    /// The forces.
    pub forces: Vec<Force>,
    /// Whether links have weight.
    pub has_gravity: bool,
    /// What a reader of the scene must know of the drawing.
    pub remarks: Vec<Remark>,
}

/// A joint, or a point of a link.
#[derive(Debug, Clone, Default)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Where it is drawn, m.
    pub at: [f64; 2],
    /// Whether it is a point of the ground.
    pub is_grounded: bool,
}

/// A rigid link.
#[derive(Debug, Clone, Default)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its joints, each once.
    pub joints: Vec<usize>,
    /// Its mass, kg.
    pub mass: f64,
    /// Where its center of mass is drawn, m; needed where it has mass.
    pub center: Option<[f64; 2]>,
    /// Moment of inertia about the center of mass, kg m^2.
    pub inertia: f64,
}

/// A prismatic pair.
#[derive(Debug, Clone, Default)]
pub struct Slide {
    /// Its name.
    pub name: String,
    /// The link that slides.
    pub link: usize,
    /// The link on which it slides; `None`: the ground.
    pub on: Option<usize>,
    /// The joint of the sliding link on the guide line.
    pub joint: usize,
    /// Where a point of the guide line is drawn, m.
    pub through: [f64; 2],
    /// The direction of the guide as it is drawn, rad.
    pub angle: f64,
}

/// A driven pair.
#[derive(Debug, Clone)]
pub struct Input {
    /// Which pair.
    pub pair: Driven,
    /// How fast its coordinate grows, rad/s or m/s; 0: not known.
    pub rate: f64,
    /// Between which values it goes there and back, from that which is drawn, rad or m; `None`: it turns.
    pub travel: Option<[f64; 2]>,
}

/// The pair of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Driven {
    /// A pin: this link turns about this joint on another one, or on the ground.
    Pin {
        /// The joint.
        joint: usize,
        /// The link that is turned.
        of: usize,
        /// On which it turns; `None`: the ground.
        on: Option<usize>,
    },
    /// A slide, by its number.
    Slide(usize),
}

/// A constant force.
#[derive(Debug, Clone)]
pub struct Force {
    /// Its name.
    pub name: String,
    /// The link on which it acts.
    pub link: usize,
    /// Where it is drawn, m.
    pub at: [f64; 2],
    /// Its direction as it is drawn, rad.
    pub angle: f64,
    /// Its size, N.
    pub value: f64,
    /// Whether it turns with the link.
    pub is_local: bool,
}

/// What a reader of the scene must know of the drawing.
#[derive(Debug, Clone)]
pub struct Remark {
    /// The remark.
    pub text: Text,
    /// Whether a part of the mechanism is not in the scene.
    pub is_lost: bool,
}

impl Drawing {
    /// Remarks that a part is said in another way, or is no part of the mechanism.
    pub fn tell(&mut self, text: Text) {
        self.remarks.push(Remark { text, is_lost: false });
    }

    /// Remarks that a part of the mechanism is not in the scene.
    pub fn lose(&mut self, text: Text) {
        self.remarks.push(Remark { text, is_lost: true });
    }

    /// Makes two links one; the other has no joint then, and is in no scene.
    pub fn weld(&mut self, [kept, other]: [usize; 2]) {
        let joints = std::mem::take(&mut self.links[other].joints);
        for joint in joints {
            if !self.links[kept].joints.contains(&joint) {
                self.links[kept].joints.push(joint);
            }
        }
    }

    /// Refuses numbers that are not finite, and more links or joints than a drawing can have.
    pub(crate) fn check(&self) -> Result<(), Text> {
        let count = self.links.len().max(self.joints.len());
        if count > MOST {
            return Err(text!("import-too-large", count, most = MOST));
        }
        let joints = self.joints.iter().map(|joint| (&joint.name, joint.at.to_vec()));
        let links = self.links.iter().map(|link| (&link.name, vec![link.mass, link.inertia]));
        let forces =
            self.forces.iter().map(|force| (&force.name, vec![force.value, force.at[0], force.at[1]]));
        let mut all = joints.chain(links).chain(forces);
        match all.find(|(_, numbers)| !numbers.iter().all(|x| x.is_finite())) {
            Some((of, _)) => Err(text!("import-not-finite", of = name(of.clone()))),
            None => Ok(()),
        }
    }
}

/// Whether two places are not one.
pub fn are_apart(one: [f64; 2], other: [f64; 2]) -> bool {
    (one[0] - other[0]).hypot(one[1] - other[1]) > 0.0
}
