//! Depending on this crate links every plugin of the repository: one line a plugin, here and nowhere else.
//!
//! `inventory` drops, without a word, a crate that no code names; so every program and test that wants plugins says
//! `use assur_all as _;`.

use assur_force_friction as _;
use assur_force_groups as _;
use assur_force_longitudinal as _;
use assur_force_newton_euler as _;
use assur_force_virtual_power as _;
use assur_group_any as _;
use assur_group_driven as _;
use assur_group_prp as _;
use assur_group_rpp as _;
use assur_group_rpr as _;
use assur_group_rrp as _;
use assur_group_rrr as _;
use assur_group_triad as _;
use assur_import_linkage as _;
use assur_import_pmks as _;
use assur_integrator_closed_form as _;
use assur_integrator_dormand_prince as _;
use assur_integrator_energy as _;
use assur_integrator_radau as _;
use assur_integrator_runge_kutta as _;
use assur_integrator_uniform as _;
use assur_motors_4a as _;
use assur_motors_air as _;
use assur_motors_iec as _;
