"""What all parts of the diagnosis ask of evidence: how far, how sure, over how long a mean."""

HALF_WAY = 0.5
"""Half-way between two hypotheses that are 1 apart in effectiveness [1]: 0 lost or held, 1 works, -1 reversed."""
BEYOND_DOUBT = 3.0
"""Standard deviations of its estimate at which a hypothesis is rejected: by chance, to one side, once in 741 independent looks."""
MEAN_S = 1.0
"""Time constant of the means of what gusts disturb, and how long a test of such a mean must hold [s]. Chosen by two healthy flights
of an OV-10 (suite `healthy`, seed 59831983, draws 15 and 18), whose elevator was taken for jammed; shorter than the filter's own
memory of b, 2 to 8 s on the v-tail."""
SLOW_S = 3.0
"""What is slow [s]: the lag of the slow estimate, several times the filter's memory of 0.6 s; how long stuck thrust, which does
harm more slowly than a stuck surface, must look stuck; how long an actuator without which altitude cannot be held must seem lost,
longer than most pauses of an intermittent failure."""
