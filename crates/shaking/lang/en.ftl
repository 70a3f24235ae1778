shaking-no-cycle = the shaking force is found over a cycle: give `[input] cycle` instead of `to`
shaking-over-time = the shaking force is balanced over a cycle, which a motion by laws over time has not: its shaking force at each instant stands in the results of `assur analyze`
shaking-no-motion = the shaking force needs a motion over the cycle: give `[motion]` of the kind prescribed or steady
shaking-no-mass = no moving link has a mass or a moment of inertia, so there is no shaking force: give `[link.NAME] mass`
