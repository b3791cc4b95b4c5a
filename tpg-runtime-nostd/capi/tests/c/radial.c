/* Prints what the library says of an arm at each pose, a line each: the hand's bits, the code of a collision, the bits of every
 * source, and a step's pose and validity. */
#include "tpg_runtime.h"

#include "arm.h"

#include <stdio.h>
#include <string.h>

static void print(const float *values, size_t count)
{
    for (size_t at = 0; at < count; at++) {
        uint32_t bits = 0;
        (void)memcpy(&bits, &values[at], sizeof bits);
        (void)printf("%08lx ", (unsigned long)bits);
    }
}

int main(void)
{
    static const uint8_t sources[] = SOURCES;
    static tpg_arm_t arm;

    if (tpg_arm_init(&arm, &description) != TPG_OK) {
        return 1;
    }
    for (size_t at = 0; at < sizeof poses / sizeof poses[0]; at++) {
        float hand[3];
        float state[TPG_STATE_LENGTH];
        int32_t collision = 0;
        int32_t validity = 0;
        tpg_observation_t seen;
        tpg_pose_t after;
        if (tpg_arm_hand(&arm, &poses[at], hand) != TPG_OK || tpg_arm_collision(&arm, &poses[at], &collision) != TPG_OK
            || tpg_observe(&arm, &poses[at], targets[at], &seen) != TPG_OK
            || tpg_arm_step(&arm, &poses[at], &moves[at], &after, &validity) != TPG_OK) {
            return 2;
        }
        print(hand, 3U);
        for (size_t source = 0; source < sizeof sources; source++) {
            (void)memset(state, 0, sizeof state);
            if (tpg_observation_state(&arm, &seen, NULL, &sources[source], 1U, state, TPG_STATE_LENGTH) != TPG_OK) {
                return 3;
            }
            print(state, LONGEST);
        }
        (void)printf("%ld %d %d %d %d %ld\n", (long)collision, after.ticks[0], after.ticks[1], after.ticks[2],
                     after.ticks[3], (long)validity);
    }
    return 0;
}
