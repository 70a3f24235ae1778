//! Forms for the tables of a scene.
