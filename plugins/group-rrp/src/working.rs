//! The working of type 2 by hand.

use assur_group::plane::dot;
use assur_group::{Body, BuildError, ClosedForm, GroupFrame, inventory};
use assur_worksheet::dyad::{across, along, compose, minus, opposite, plus};
use assur_worksheet::{Expr, Guide, Point, Sheet, WorkingPlugin};

use crate::Rrp;

inventory::submit! {
    WorkingPlugin { group: "rrp", crate_name: env!("CARGO_PKG_NAME"), motion, reactions }
}

fn motion(sheet: &mut Sheet, frame: &GroupFrame, bodies: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rrp::<f64>::new(frame)?;
    let [rod, slider] = pairs.links;
    let end = &pairs.slide;
    let (a, through) = (sheet.point(pairs.end.body, pairs.end.at), sheet.point(end.body, end.through));
    sheet.outline("outer pin", &a);
    sheet.outline_angle("body with the guide", end.body);
    let guide = sheet.guide_of(&pairs.slide);
    let name = sheet.place_name(rod, pairs.inner.own);
    let length = sheet.rod(rod, pairs.end.own, pairs.inner.own);
    let what = format!("distance of {name} to the left of the guide line");
    let k = sheet.fixed_length("k", pairs.slide.offset(pairs.inner.at), &what);
    let number = bodies[rod].point(pairs.inner.own);
    let foot = bodies[rod].point(pairs.end.own);
    let t = bodies[end.body].turned([end.along_angle.cos(), end.along_angle.sin()]);
    let ahead = dot(t, [number[0] - foot[0], number[1] - foot[1]]) >= 0.0;
    let side = if ahead {
        "ahead of the foot, in the direction of the guide: sign +"
    } else {
        "behind the foot: sign -"
    };
    sheet.note(format!("PF0: distance delta of {name} from {} across the guide, sigma along it;", a.name));
    sheet.note(format!("{name} is {side}"));
    let (delta_name, sigma_name) = (sheet.local("delta"), sheet.local("sigma"));
    let delta = sheet.work(&delta_name, &(across(&guide.t, &through.from(&a, 0)) + k), "m");
    let l = &length.length;
    let root = ((l - &delta) * (l + &delta)).sqrt();
    let sigma = sheet.work(&sigma_name, &(if ahead { root } else { -root }), "m");
    let c = sheet.vector(&name, 0, &plus(&a.pf[0], &compose(&guide.t, &sigma, &delta)));
    let r = minus(&c, &a.pf[0]);
    let phi = sheet.rod_angle(rod, &length, &r);
    let slider_angle = slider_angle(sheet, &pairs, &guide);
    let (first, second) = derive(sheet, &pairs, [&a, &through], &guide, [&c, &r], [&delta, &sigma]);
    sheet.place(rod, &a, pairs.end.own, [phi, first, second]);
    let pin = sheet.point(rod, pairs.inner.own);
    sheet.place_turned(slider, &pin, pairs.inner.at, &slider_angle, end.body);
    Ok(())
}

fn slider_angle(sheet: &mut Sheet, pairs: &Rrp<f64>, guide: &Guide) -> Expr {
    let name = format!("tilt_{}", sheet.pair_tag(pairs.slide.id));
    let what = format!("angle of {} from the guide", sheet.body_name(pairs.links[1]));
    let tilt = sheet.fixed_angle(&name, pairs.slide.tilt_angle, &what);
    &guide.alpha + tilt
}

/// Writes PF1 and PF2 of the rod's angle and of the inner pin, which is added to the sheet.
fn derive(
    sheet: &mut Sheet,
    pairs: &Rrp<f64>,
    [a, through]: [&Point; 2],
    guide: &Guide,
    [c, r]: [&[Expr; 2]; 2],
    [delta, sigma]: [&Expr; 2],
) -> (Expr, Expr) {
    let (rod, body, t) = (pairs.links[0], pairs.slide.body, &guide.t);
    let name = sheet.place_name(rod, pairs.inner.own);
    let carrier = sheet.body_name(body).to_owned();
    let units = sheet.units.length;
    let with = if body == 0 {
        "does not move"
    } else {
        "moves like the point of the carrier that coincides with it, with V"
    };
    sheet.note(format!("PF1: across the guide on {carrier}, {name} {with}"));
    let of = sheet.local("under");
    let v = sheet.under(body, through, c, 1);
    let v = sheet.components("V", &of, &v, units[1]);
    let first = across(t, &minus(&v, &a.pf[1])) / sigma;
    let first = sheet.link_rate(rod, 1, &first);
    let turned = |rate: &Expr| [-(rate * &r[1]), rate * &r[0]];
    let c1 = sheet.vector(&name, 1, &plus(&a.pf[1], &turned(&first)));
    let rate = sheet.angle(body)[1].clone();
    let mut coriolis = Expr::zero();
    if rate.is_zero() {
        sheet.note(format!("PF2: normal part n of {name} about {}", a.name));
    } else {
        sheet.note(format!(
            "PF2: normal part n of {name} about {}; vr along the guide, Coriolis part kor across it",
            a.name
        ));
        let (vr, kor) = (sheet.local("vr"), sheet.local("kor"));
        let relative = sheet.work(&vr, &along(t, &minus(&c1, &v)), units[1]);
        coriolis = sheet.work(&kor, &(Expr::number(2.0) * &rate * &relative), units[2]);
    }
    let w = sheet.under(body, through, c, 2);
    let w = sheet.components("W", &of, &w, units[2]);
    let normal = sheet.normal_part(&format!("{name}_{}", a.name), &first, r);
    let part = across(t, &minus(&w, &a.pf[2])) + coriolis + first.squared() * delta;
    let second = sheet.link_rate(rod, 2, &(part / sigma));
    let c2 = sheet.vector(&name, 2, &plus(&plus(&a.pf[2], &turned(&second)), &normal));
    sheet.set_point(rod, pairs.inner.own, [c.clone(), c1, c2]);
    (first, second)
}

fn reactions(sheet: &mut Sheet, frame: &GroupFrame, _: &[Body<f64>]) -> Result<(), BuildError> {
    let pairs = Rrp::<f64>::new(frame)?;
    let [rod, slider] = pairs.links;
    let end = pairs.slide;
    let a = sheet.point(pairs.end.body, pairs.end.at);
    let c = sheet.point(rod, pairs.inner.own);
    let on_line = sheet.point(slider, end.own);
    let guide = sheet.guide_of(&pairs.slide);
    let (one, two) = (sheet.resultant(rod), sheet.resultant(slider));
    sheet.note(format!(
        "along the guide {} transmits its load to {}; moments about {} give the component across",
        sheet.body_name(slider),
        c.name,
        a.name
    ));
    let (ft, fn_) = (sheet.local("Ft"), sheet.local("Fn"));
    let along_guide = sheet.work_unless_zero(&ft, &along(&guide.t, &two), "N");
    let m = sheet.moment_about(rod, &a);
    let (delta, sigma) = (sheet.recall("delta"), sheet.recall("sigma"));
    let normal = sheet.work_unless_zero(&fn_, &((&delta * &along_guide - m) / sigma), "N");
    let inner = compose(&guide.t, &along_guide, &normal);
    let inner = sheet.pin_reaction(pairs.inner.id, rod, &c, &inner);
    sheet.note("forces on each link, then moments on the sliding link about its point on the guide:");
    let at_a = sheet.pin_reaction(pairs.end.id, rod, &a, &opposite(&plus(&one, &inner)));
    sheet.hand_on(pairs.end.body, &a, &at_a, &Expr::zero());
    let name = sheet.local("N");
    let pressure = sheet.work(&name, &(normal - across(&guide.t, &two)), "N");
    let force = compose(&guide.t, &Expr::zero(), &pressure);
    let load = sheet.moment_about(slider, &on_line);
    let moment = -(load + c.moment_about(&on_line, &opposite(&inner)));
    let (force, moment) = sheet.slide_reaction(pairs.slide.id, slider, &on_line, &force, &moment);
    sheet.hand_on(end.body, &on_line, &force, &moment);
    Ok(())
}
