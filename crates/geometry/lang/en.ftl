geometry-part-of-cycle = the motion is measured over the whole cycle (`[input] from` and `to` choose a part of it): { $cause }
