geometry-part-of-cycle = движение измеряется за весь цикл (`[input] from` и `to` выбирают его часть): { $cause }
