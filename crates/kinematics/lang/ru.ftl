kinematics-position = положение { $number }
kinematics-coordinate = координата { $coordinate }: { $cause }
kinematics-range = механизм можно собрать от { $low } до { $high }
kinematics-no-range = в первом положении его нельзя собрать: проверьте длины{ $units } и направления направляющих или начните с другого места (`input.from`)
kinematics-units = {" "}и их единицы (число без единицы — в метрах)
kinematics-no-start = { $group } решается итерациями, которым нужно начальное приближение: задайте в [assembly] примерные места этих точек в первом положении: { $points }
kinematics-through-origin = направляющая `{ $slide }` проходит через начало системы `{ $on }`, как всегда без `through`: задайте `through`, если она проходит в другом месте
kinematics-parallel-guides = { $group } нельзя разместить нигде: направляющие `{ $one }` и `{ $other }` параллельны, и звено между ними не держит ни одна; поверните одну из них (`angle`)
