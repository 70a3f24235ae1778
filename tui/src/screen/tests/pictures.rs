//! Pictures of the views without a terminal.

use std::path::Path;

use super::{View, opened, press};
use crate::screen::draw::cells;
use crate::screen::state::{State, Zoom};
use crate::screen::still::{self, Request, StillError, views};
use crate::screen::view;

fn request(view: &str) -> Request {
    Request { view: view.to_owned(), part: None, show: None, position: 5, size: None, animate: false }
}

fn analyzed(name: &str, request: &Request) -> State {
    let scene = still::open(assur_fixtures::path(&format!("{name}.toml"))).unwrap();
    still::analyzed(scene, [None, None], request.shows_checks(), assur_words::Language::english())
}

fn picture(request: &Request, output: &str) -> Result<String, StillError> {
    still::draw(analyzed("shaper-drive", request), request, Path::new(output))
        .map(|bytes| String::from_utf8(bytes).unwrap())
}

#[test]
fn every_view_with_a_figure_has_a_picture() {
    for view in views() {
        let text = picture(&request(view), "x.svg").unwrap();
        assert!(text.contains("<polyline") && text.ends_with("</svg>\n"), "{view}");
    }
}

#[test]
fn a_request_without_a_meaning_is_refused_in_words() {
    let refused = |request: Request, output: &str| match picture(&request, output) {
        Err(StillError::Request(text)) => text.to_string(),
        other => panic!("{other:?}"),
    };
    assert!(refused(Request { position: 48, ..request("curves") }, "x.svg").contains("0 to 47"));
    let part = Request { part: Some("hodgraph".into()), ..request("forces") };
    assert!(refused(part, "x.svg").contains("hodograph"));
    assert!(
        refused(Request { show: Some("nothing".into()), ..request("forces") }, "x.svg").contains("nothing")
    );
    assert!(refused(request("curves"), "x.pdf").contains(".svg or .png"));
    assert!(refused(Request { animate: true, ..request("mechanism") }, "x.png").contains("SVG"));
}

#[test]
fn a_view_without_a_figure_says_what_the_scene_lacks() {
    for (name, view, why) in [("brake", "forces", "initial state"), ("four-bar", "drive", "no steady regime")]
    {
        let request = request(view);
        match still::draw(analyzed(name, &request), &request, Path::new("x.svg")) {
            Err(StillError::Nothing(text)) => assert!(text.to_string().contains(why), "{text}"),
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn an_animation_moves_the_links_and_not_the_ground() {
    let text = picture(&Request { animate: true, ..request("mechanism") }, "x.svg").unwrap();
    let moving = text.lines().filter(|line| line.contains("<animate")).count();
    let still = text.lines().filter(|line| line.starts_with("<p") && !line.contains("<animate")).count();
    assert!(moving > 10 && still > 10, "{moving} {still}");
    let values = text.split("values=\"").nth(1).unwrap().split('"').next().unwrap();
    assert_eq!(values.split(';').count(), 49, "48 positions, and the first one again");
}

#[test]
fn the_screen_and_the_file_show_the_same_signs_of_a_curve() {
    let mut state = opened("shaper");
    press(&mut state, "2");
    let figure = view::figure(&state, View::Curves).unwrap();
    let spots = assur_figure::cells::draw(&figure, [200, 60], cells(&state, Zoom::WHOLE));
    let on_screen = |text: &str| spots.iter().filter(|spot| spot.text == text).count();
    let svg = assur_figure::svg::write(&figure, [160.0, 120.0], assur_words::Language::english());
    // A ring is the only circle of a curve; one stands in the legend.
    assert_eq!(on_screen("o"), svg.matches("<circle").count() - 1);
}
