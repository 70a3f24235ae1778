kinematics-position = положення { $number }
kinematics-coordinate = координата { $coordinate }: { $cause }
kinematics-range = механізм можна зібрати від { $low } до { $high }
kinematics-no-range = у першому положенні його не можна зібрати: перевірте довжини{ $units } і напрями напрямних або почніть з іншого місця (`input.from`)
kinematics-units = {" "}та їхні одиниці (число без одиниці — у метрах)
kinematics-no-start = { $group } розв’язується ітераціями, яким потрібне початкове наближення: задайте в [assembly] приблизні місця цих точок у першому положенні: { $points }
kinematics-through-origin = напрямна `{ $slide }` проходить через початок системи `{ $on }`, як завжди без `through`: задайте `through`, якщо вона проходить деінде
kinematics-parallel-guides = { $group } не можна розмістити ніде: напрямні `{ $one }` та `{ $other }` паралельні, тож ланку між ними не тримає жодна; поверніть одну з них (`angle`)
