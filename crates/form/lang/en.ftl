# Forms for the tables of a scene.
form-not-negative = 0 or greater
form-positive = greater than 0
form-direction = at most 1000 turns either way
form-no-rod = link `{ $link }` has no two points apart from each other, between which a rod could lie
