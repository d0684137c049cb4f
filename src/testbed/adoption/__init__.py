"""Adoption: from a JSBSim model to an aircraft's folder that flies here, without hand work.

The model's own XML is kept, in one file. Between each actuator and what reads its position a block of properties is put
(docs/reference/aircraft), through which the controller commands and failures act. The model's flight control still runs, for
flaps and gear, but what it says to these actuators is not heard.
"""
