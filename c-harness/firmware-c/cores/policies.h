/* The shipped policies as functions of one kind. `cargo xtask cores` writes policies.c, in C and for the generated Rust. */
#ifndef POLICIES_H
#define POLICIES_H

#include <stdint.h>

/* At most so many values are seen, and answered: an action, or outputs and the next memory. */
#define MOST_VALUES 24U

typedef struct policy {
    const char *name;
    uint8_t inputs;
    uint8_t answers;
    /* For each input the low end of its range, and a 16,777,216th of the range. */
    const float *low;
    const float *step;
    /* Puts the answer's bits to a state into its second argument; the instructions of it. */
    uint32_t (*answer)(const float *state, uint32_t *bits);
} policy_t;

extern const policy_t policies[];
extern const uint8_t policy_count;

#endif
