group-driven = a link that is driven against a moving link
    .ways = one
    .singular = none
    .source = the initial mechanism of class I with a moving link as its ground
