//! Functions on a panel, an interval on which a polynomial through the values at some nodes stands for them: by
//! [`chebyshev`] polynomials where it is integrated and inverted, by [`Radau`] collocation where it solves an equation, and by
//! the barycentric formula through any nodes, and by Bernstein's coefficients where its bounds are asked for.

mod bernstein;
pub mod chebyshev;
mod radau;

pub use bernstein::Bernstein;
pub use radau::Radau;

/// Weights of the barycentric formula for these nodes (Berrut & Trefethen, eq. 3.2).
pub fn weights<const N: usize>(nodes: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|k| {
        let product: f64 = (0..N).filter(|m| *m != k).map(|m| nodes[k] - nodes[m]).product();
        1.0 / product
    })
}

/// Share of each node in the value at `x` of the polynomial through the values at the nodes, which are given with their
/// weights: by the barycentric formula of the second kind, backward stable and exact at the nodes. No more than `N` nodes;
/// with fewer the last shares are 0.
pub fn shares<const N: usize>(x: f64, nodes: impl IntoIterator<Item = (f64, f64)>) -> [f64; N] {
    let (mut shares, mut sum) = ([0.0; N], 0.0);
    for (i, (share, (node, weight))) in shares.iter_mut().zip(nodes).enumerate() {
        let away = x - node;
        if away == 0.0 {
            let mut only = [0.0; N];
            only[i] = 1.0;
            return only;
        }
        *share = weight / away;
        sum += *share;
    }
    shares.map(|share| share / sum)
}
