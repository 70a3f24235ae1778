# What is wrong with a formula.
formula-too-long = a formula has at most { $most } characters, this one { $count }
formula-many-signs = a formula has at most { $most } signs, powers and parentheses
formula-too-deep = the formula is nested deeper than { $most } levels
formula-ends-early = the formula ends too early: an operand or `)` is missing
formula-misplaced-sign = `{ $sign }` does not fit here in the formula; it knows { $known }
formula-great-number = the number { $number } is beyond all that can be calculated with
formula-unknown-name = `{ $name }` is unknown in a formula; it knows { $known }
formula-arguments = `{ $name }` takes { $count ->
    [one] { $count } argument
   *[other] { $count } arguments
 }, got { $got }
formula-many-switches = a formula has at most { $most } of sign, step, abs, min, max and atan2
formula-foreign-sign = `{ $sign }` does not stand in a formula: it has Latin letters, digits and + - * / ^
formula-power-sign = a power is written with `^`: q^2
formula-decimal-comma = is a comma meant as the decimal sign? it is a point
formula-condition = a condition is written with `step`: step(q - 3) is 0 below q = 3 and 1 above it
formula-parentheses = the argument of a function stands in parentheses, as in sin(q); `{ $sign }` follows without one
formula-missing-sign = a sign is missing after { $number }: write `*` between a number and a name; units stand in `unit`
formula-meant = `{ $name }` is unknown in a formula: did you mean `{ $meant }`?
