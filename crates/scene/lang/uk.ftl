# Назви навантажень, яких сцена не називає.
scene-unnamed-force = сила { $number } на ланці { $link }
scene-unnamed-moment = момент { $number } на ланці { $link }
scene-unnamed-brake = гальмо { $number } на ланці { $link }
scene-unnamed-spring = пружина { $number }
scene-unnamed-contact = контакт { $number } на ланці { $link }
