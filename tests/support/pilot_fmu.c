/* examples/pilot.c as an FMU, with FMI=2 or FMI=3: a value reference is the place of a signal in `values`.
   The parameter `fault` makes it do what no unit should. */

#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "pilot.c"

enum { SENSED = 0, PITCH = 14, REFERENCE = 21, DT = 27, TRIM_PITCH = 28, TRIM = 29, COMMANDS = 33, GAIN = 37, VALUES = 38 };

typedef struct {
    double values[VALUES];
    int fault, flying;
    testbed_setup setup;
    void *pilot;
} unit;

static void *made(void) {
    unit *self = calloc(1, sizeof *self);
    self->values[GAIN] = 1.0;
    return self;
}

static int begun(void *memory) {
    unit *self = memory;
    testbed_setup setup = {1, 4, self->values[DT], self->values[TRIM_PITCH], 0, 0, 0, 0, self->values + TRIM, ""};
    self->setup = setup;
    self->pilot = testbed_bind(&self->setup);
    return 0;
}

static int stepped(void *memory, double at) {
    unit *self = memory;
    if (at > 0.0995 && self->fault) {
        if (self->fault == 1) return 3;
        if (self->fault == 2) self->values[GAIN] = NAN;
        if (self->fault == 3) raise(11);
        if (self->fault == 4) sleep(600);
        if (self->fault == 5) printf("{\"commands\": []}\n"), fflush(stdout);
    }
    self->values[PITCH] *= M_PI / 180.0; /* its unit is deg */
    testbed_step(self->pilot, (void *)(self->values + SENSED), (void *)(self->values + REFERENCE), self->values + COMMANDS);
    self->values[COMMANDS] *= self->values[GAIN];
    return 0;
}

static int set(void *memory, const unsigned *references, size_t n, const double *from) {
    for (size_t i = 0; i < n; i++) ((unit *)memory)->values[references[i]] = from[i];
    return 0;
}

static int got(void *memory, const unsigned *references, size_t n, double *to) {
    for (size_t i = 0; i < n; i++) to[i] = ((unit *)memory)->values[references[i]];
    return 0;
}

static int fault(void *memory, const int *value) { return ((unit *)memory)->fault = *value, 0; }
static int ended(void *memory) { return testbed_close(((unit *)memory)->pilot), 0; }

#if FMI == 2
void *fmi2Instantiate(const char *name, int kind, const char *guid, const char *where, const void *calls, int show, int log) {
    return strcmp(guid, "pilot") ? NULL : made();
}
int fmi2SetupExperiment(void *m, int has, double tolerance, double start, int ends, double stop) { return 0; }
int fmi2EnterInitializationMode(void *m) { return 0; }
int fmi2ExitInitializationMode(void *m) { return begun(m); }
int fmi2SetReal(void *m, const unsigned *r, size_t n, const double *v) { return set(m, r, n, v); }
int fmi2GetReal(void *m, const unsigned *r, size_t n, double *v) { return got(m, r, n, v); }
int fmi2SetInteger(void *m, const unsigned *r, size_t n, const int *v) { return fault(m, v); }
int fmi2DoStep(void *m, double at, double dt, int no) { return stepped(m, at); }
int fmi2Terminate(void *m) { return ended(m); }
void fmi2FreeInstance(void *m) { free(m); }
#else
void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *where, _Bool show, _Bool log, _Bool events,
                                  _Bool early, const unsigned *r, size_t n, void *e, void *logs, void *update) {
    return strcmp(token, "pilot") ? NULL : made();
}
int fmi3EnterInitializationMode(void *m, _Bool has, double tolerance, double start, _Bool ends, double stop) { return 0; }
int fmi3ExitInitializationMode(void *m) { return begun(m); }
int fmi3SetFloat64(void *m, const unsigned *r, size_t n, const double *v, size_t k) { return set(m, r, n, v); }
int fmi3GetFloat64(void *m, const unsigned *r, size_t n, double *v, size_t k) { return got(m, r, n, v); }
int fmi3SetInt32(void *m, const unsigned *r, size_t n, const int *v, size_t k) { return fault(m, v); }
int fmi3DoStep(void *m, double at, double dt, _Bool no, _Bool *event, _Bool *end, _Bool *early, double *last) {
    *event = *end = *early = 0;
    *last = at + dt;
    if (((unit *)m)->fault == 6) *end = 1;
    return stepped(m, at);
}
int fmi3Terminate(void *m) { return ended(m); }
void fmi3FreeInstance(void *m) { free(m); }
#endif
