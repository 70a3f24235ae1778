# Names of loads that the scene does not name.
scene-unnamed-force = force { $number } on { $link }
scene-unnamed-moment = moment { $number } on { $link }
scene-unnamed-brake = brake { $number } on { $link }
scene-unnamed-spring = spring { $number }
scene-unnamed-contact = contact { $number } on { $link }
