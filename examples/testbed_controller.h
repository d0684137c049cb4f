/* A controller for the testbed in a C library: write these three functions.

   cc -O2 -shared -fPIC -o pilot.so pilot.c -lm
   testbed run scenarios/left_tail_fail.yaml --controller ./pilot.so

   Angles are in radians; frames and signs are those of the log: body axes x forward, y right, z down; north, east, down. */

#ifndef TESTBED_CONTROLLER_H
#define TESTBED_CONTROLLER_H

#define TESTBED_VERSION 1

typedef struct {
    int version;              /* TESTBED_VERSION of the program that calls */
    int actuators;            /* n: how many there are */
    double dt_s;              /* duration of a control step */
    double trim_pitch;        /* pitch at the start */
    const char *const *names; /* [n] of the actuators */
    const int *is_servo;      /* [n] 1 for a servo (commands in rad), 0 for a motor or engine (throttle 0 to 1) */
    const double *low, *high; /* [n] stops of the position [rad or N] */
    const double *trim;       /* [n] commands at the start [rad or throttle] */
    const char *json;         /* the same and more: seed, parameters, scenario, a folder for files of your own */
} testbed_setup;

/* What the sensors read now. */
typedef struct {
    double time;
    double p, q, r;
    double force_x, force_y, force_z; /* specific force [m/s2] */
    double velocity_north, velocity_east, velocity_down;
    double north, east, altitude; /* from the start [m]; altitude above sea level */
    double roll, pitch, heading;
    double airspeed, alpha, beta;
    double pressure, temperature; /* static [Pa]; of the air [K] */
} testbed_sensed;

/* What is to be followed, and its rates. */
typedef struct {
    double altitude, airspeed, heading;
    double altitude_rate, airspeed_rate, heading_rate;
} testbed_reference;

/* Before a flight. Returns a pointer of yours, which the others are given, or NULL to refuse. `setup` stays until close. */
void *testbed_bind(const testbed_setup *setup);

/* A control step: fill commands [n]. Returns 0, or anything else to end the flight. */
int testbed_step(void *self, const testbed_sensed *sensed, const testbed_reference *reference, double *commands);

/* After a flight. */
void testbed_close(void *self);

#endif
