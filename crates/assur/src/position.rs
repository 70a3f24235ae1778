//! A mechanism at one coordinate.

use assur_group::Body;
use assur_kinematics::Linkage;
use assur_number::elementary;

use crate::Error;

/// A mechanism at one coordinate of its input. Derivatives are by that coordinate.
#[derive(Debug, Clone)]
pub struct Position<'a> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) solved: assur_kinematics::Position,
}

impl Position<'_> {
    /// The place of a point, m.
    ///
    /// # Errors
    ///
    /// No point has the name; the error names the most similar.
    pub fn point(&self, name: &str) -> Result<[f64; 2], Error> {
        self.transfer(name).map(|[place, ..]| place)
    }

    /// The transfer functions of a point: its place, and the first and second derivative.
    ///
    /// # Errors
    ///
    /// As those of [`point`](Self::point).
    pub fn transfer(&self, name: &str) -> Result<[[f64; 2]; 3], Error> {
        let points = &self.linkage.mechanism.points;
        let places = self.linkage.mechanism.point(name).map(|point| &points[point].places);
        let place = places.and_then(|places| places.first());
        let place = place
            .ok_or_else(|| Error::unknown("point", name, points.iter().map(|point| point.name.as_str())))?;
        let body = &self.solved.bodies[place.link];
        let arm = body.arm(place.at);
        Ok([body.point(place.at), body.first(arm), body.second(arm)])
    }

    /// The angle of a link in (-pi, pi], rad, and its first and second derivative.
    ///
    /// # Errors
    ///
    /// No link has the name; the error names the most similar.
    pub fn link(&self, name: &str) -> Result<[f64; 3], Error> {
        let Body { c, s, w1, w2, .. } = *self.body(name)?;
        Ok([elementary::atan2(s, c), w1, w2])
    }

    /// The place of the origin of a link, m.
    ///
    /// # Errors
    ///
    /// As those of [`link`](Self::link).
    pub fn origin(&self, name: &str) -> Result<[f64; 2], Error> {
        Ok(self.body(name)?.origin())
    }

    fn body(&self, name: &str) -> Result<&Body<f64>, Error> {
        let mechanism = &self.linkage.mechanism;
        let link = mechanism.link(name);
        let link = link.ok_or_else(|| {
            Error::unknown("link", name, mechanism.links.iter().map(|link| link.name.as_str()))
        })?;
        Ok(&self.solved.bodies[link])
    }
}
