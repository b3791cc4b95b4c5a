/* The types of the table of sensor faults in faults.h, which is made from src/scenarios.rs; their names are the table's. */
#ifndef SCENARIOS_H
#define SCENARIOS_H

#include "tpg_runtime.h"

#include <stdbool.h>

typedef enum reading {
    READING_Good,
    READING_Stuck,
    READING_JointStuck,
    READING_Late,
    READING_Jump,
    READING_Fixed,
    READING_Flicker,
    READING_HandNan,
    READING_DifferenceInfinite,
    READING_HandOff,
    READING_HandInfinite
} reading_t;

typedef enum aim { TARGET_Good, TARGET_Nan, TARGET_Infinite, TARGET_Huge, TARGET_Far } aim_t;

typedef struct phase {
    uint16_t steps;
    reading_t reading;
    uint8_t joint;
    int16_t amount;
    aim_t target;
    bool resume;
    int32_t code;
    uint16_t within;
} phase_t;

typedef struct scenario {
    const char *name;
    tpg_watch_t watch;
    const phase_t *phases;
    size_t count;
} scenario_t;

#endif
