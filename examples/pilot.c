/* The controller of my_controller.py as a C library: loops on pitch, yaw and airspeed for a v-tail with two motors.

   cc -O2 -shared -fPIC -o pilot.so pilot.c -lm
   testbed run left_tail_fail.yaml --controller ./pilot.so */

#include <math.h>
#include <stdlib.h>

#include "testbed_controller.h"

typedef struct {
    const testbed_setup *setup;
    double climb; /* integral of the altitude's error */
} pilot;

static double clipped(double x, double most) { return fmax(-most, fmin(most, x)); }

void *testbed_bind(const testbed_setup *setup) {
    if (setup->version != TESTBED_VERSION || setup->actuators != 4) return NULL;
    pilot *self = calloc(1, sizeof *self);
    if (self) self->setup = setup;
    return self;
}

int testbed_step(void *memory, const testbed_sensed *y, const testbed_reference *r, double *commands) {
    pilot *self = memory;
    const testbed_setup *setup = self->setup;
    double error = r->altitude - y->altitude;
    self->climb += 0.02 * error * setup->dt_s;
    double pitch = setup->trim_pitch + (r->altitude_rate + 0.5 * error + self->climb) / y->airspeed;
    double elevator = 0.3 * (y->pitch - pitch) + 0.1 * y->q; /* positive trailing edge down: nose down */

    double turn = remainder(r->heading - y->heading, 2.0 * M_PI);
    double bank = clipped(1.8 * (r->heading_rate + 0.5 * turn), 0.4);
    double yaw_rate = 9.8 / y->airspeed * sin(y->roll) + 1.0 * (bank - y->roll);
    double rudder = 0.3 * (yaw_rate - y->r); /* positive nose right: the left surface up, the right one down */
    double throttle = 0.1 * (r->airspeed - y->airspeed);

    commands[0] = setup->trim[0] + elevator - rudder;
    commands[1] = setup->trim[1] + elevator + rudder;
    commands[2] = setup->trim[2] + throttle;
    commands[3] = setup->trim[3] + throttle;
    return 0;
}

void testbed_close(void *self) { free(self); }
