geometry-part-of-cycle = рух вимірюється за весь цикл (`[input] from` і `to` вибирають його частину): { $cause }
