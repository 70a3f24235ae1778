# Что не так с формулой.
formula-too-long = в формуле не более { $most } знаков, а здесь { $count }
formula-many-signs = в формуле не более { $most } знаков действий, степеней и скобок
formula-too-deep = вложенность формулы больше { $most } уровней
formula-ends-early = формула обрывается: не хватает операнда или `)`
formula-misplaced-sign = `{ $sign }` здесь в формуле не место; известны { $known }
formula-great-number = с числом { $number } нельзя вычислять: оно слишком велико
formula-unknown-name = `{ $name }` в формуле неизвестно; известны { $known }
formula-arguments = `{ $name }`: аргументов должно быть { $count }, а задано { $got }
formula-many-switches = в формуле не более { $most } вызовов sign, step, abs, min, max и atan2
formula-foreign-sign = `{ $sign }` в формуле недопустимо: в ней латинские буквы, цифры и + - * / ^
formula-power-sign = степень пишут через `^`: q^2
formula-decimal-comma = запятая здесь — десятичный разделитель? им должна быть точка
formula-condition = условие пишут через `step`: step(q - 3) равно 0 до q = 3 и 1 после
formula-parentheses = аргумент функции пишут в скобках, например sin(q); здесь далее стоит `{ $sign }`
formula-missing-sign = после { $number } не хватает знака действия: между числом и именем пишите `*`; единицу задают в `unit`
formula-meant = `{ $name }` в формуле неизвестно: имелось в виду `{ $meant }`?
