# Названия нагрузок, которых сцена не называет.
scene-unnamed-force = сила { $number } на звене { $link }
scene-unnamed-moment = момент { $number } на звене { $link }
scene-unnamed-brake = тормоз { $number } на звене { $link }
scene-unnamed-spring = пружина { $number }
scene-unnamed-contact = контакт { $number } на звене { $link }
