# What is wrong with a formula.
formula-too-long = a formula has at most { $most } characters, this one { $count }
formula-many-signs = a formula has at most { $most } operators, powers and parentheses
formula-too-deep = the formula is nested deeper than { $most } levels
formula-ends-early = the formula ends too early: an operand or `)` is missing
formula-misplaced-sign = `{ $sign }` is out of place in the formula; available are { $known }
formula-great-number = the number { $number } is too large to calculate with
formula-unknown-name = `{ $name }` is unknown in a formula; available are { $known }
formula-arguments = `{ $name }` takes { $count ->
    [one] { $count } argument
   *[other] { $count } arguments
 }, got { $got }
formula-many-switches = a formula has at most { $most } calls of sign, step, abs, min, max and atan2
formula-foreign-sign = `{ $sign }` is not allowed in a formula: it has Latin letters, digits and + - * / ^
formula-power-sign = a power is written with `^`: q^2
formula-decimal-comma = is the comma meant as a decimal separator? it must be a point
formula-condition = a condition is written with `step`: step(q - 3) is 0 below q = 3 and 1 above it
formula-parentheses = the argument of a function is written in parentheses, as in sin(q); here `{ $sign }` follows
formula-missing-sign = an operator is missing after { $number }: write `*` between a number and a name; a unit goes into `unit`
formula-meant = `{ $name }` is unknown in a formula: did you mean `{ $meant }`?
