"""Fly by hand: break a surface when you like, look at what the controller believes, mend it, and keep the flight.

python by_hand.py
"""

import testbed

with testbed.Session("scenarios/left_tail_fail.yaml", set={"failures": [], "requirements": []}) as session:
    session.run_to(5.0)  # seconds
    session.inject({"type": "effectiveness", "actuator": "left_ruddervator", "value": 0.2})
    while session.belief["left_ruddervator_effectiveness_estimate"] > 0.3 and session.ended is None:
        session.step()
    print(f"seen after {session.time_s - 5.0:.2f} s")
    session.blow({"wind_m_s": [0.0, 4.0, 0.0], "duration_s": 2.0})
    session.order({"altitude_m": 305, "heading_deg": 120})
    session.run_to(20.0)
    session.mend("left_ruddervator")
    session.step(5 * 200)
    print(f"at {session.truth['altitude_m']:.1f} m, roll {session.measured['roll_deg']:.1f} deg")
    flight = session.flight()  # of what was flown so far

flight.save("by hand")  # its scenario.yaml has all that was done, and flies to the same bytes
