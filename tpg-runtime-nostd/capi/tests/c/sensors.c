/* The two shipped hybrids on readings that cannot be, judged here in plain C: no decision moves the arm on any of them. Run
 * with a seed and a number of episodes. Prints the first decision that broke the contract. */
#include "tpg_runtime.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"
#include "numbers.h"
#include "widowx_fs.h"
#include "widowx_rs.h"

#define STEPS 60U

typedef enum mode { CLEAN, TARGET_MOVES, POSE_JUMPS, STUCK, ANY_POSE, ANY_TARGET, MODES } disturbance_t;

static const char *const names[MODES] = { "clean", "target-moves", "pose-jumps", "stuck", "any-pose", "any-target" };

static int32_t below(uint32_t bound)
{
    return (int32_t)(number() % bound);
}

static float any_float(void)
{
    static const float odd[5] = { NAN, INFINITY, -INFINITY, 1e38F, 0.0F };
    const int32_t pick = below(7U);

    return (pick < 5) ? odd[pick] : (float)(below(1200U) - 600);
}

static uint16_t infer_fs(const void *state_of)
{
    return (uint16_t)widowx_fs_infer((const widowx_fs_state_t *)state_of);
}

static uint16_t infer_rs(const void *state_of)
{
    return (uint16_t)widowx_rs_infer((const widowx_rs_state_t *)state_of);
}

static tpg_arm_t arm;

/* The code that the contract asks for, or TPG_OK where a stuck motor is still possible. */
static int32_t due(const tpg_observation_t *seen)
{
    static const int16_t lowest[TPG_JOINTS] = { 2, 1025, 1025, 1025 };
    static const int16_t highest[TPG_JOINTS] = { 4094, 3071, 3071, 3071 };
    double square = 0.0;
    bool good = true;

    for (size_t k = 0U; k < 3U; k++) {
        const double from_shoulder = (double)seen->target[k] - ((k == 2U) ? 125.0 : 0.0);
        const float difference = seen->target[k] - seen->hand[k];

        square += from_shoulder * from_shoulder;
        good = good && isfinite(seen->hand[k]) && (seen->difference[k] == difference);
    }
    /* The square of the arm's length and a millimetre, 200898.04: integers lie far enough from it for a float. */
    if (!(square < (448.2165 * 448.2165))) {
        return TPG_BAD_TARGET;
    }
    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        good = good && (seen->pose.ticks[joint] >= lowest[joint]) && (seen->pose.ticks[joint] <= highest[joint]);
    }
    return good ? TPG_OK : TPG_BAD_SENSOR;
}

static bool is_zero(const tpg_move_t *wanted)
{
    static const tpg_move_t zero = { { 0, 0, 0, 0 } };

    return memcmp(wanted, &zero, sizeof zero) == 0;
}

/* What is wrong with a decision; NULL for nothing. */
static const char *judge(const tpg_observation_t *seen, int32_t code, const tpg_chosen_t *chosen, bool same_counts)
{
    const int32_t wanted = due(seen);
    tpg_pose_t after;
    int32_t here = TPG_VALID;
    int32_t there = TPG_VALID;

    if ((code != wanted) && !((wanted == TPG_OK) && (code == TPG_STUCK))) {
        return "another code";
    }
    if (code != TPG_OK) {
        return !is_zero(&chosen->wanted) ? "a move with a fault" : (same_counts ? NULL : "a fault left a trace");
    }
    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        if ((chosen->wanted.ticks[joint] < -3) || (chosen->wanted.ticks[joint] > 3)) {
            return "a move beyond 3 ticks";
        }
    }
    if ((tpg_arm_collision(&arm, &seen->pose, &here) != TPG_OK)
        || (tpg_arm_step(&arm, &seen->pose, &chosen->wanted, &after, &there) != TPG_OK)) {
        return "no step";
    }
    return ((here == TPG_VALID) && (there != TPG_VALID)) ? "an invalid move from a free pose" : NULL;
}

static void garble(disturbance_t mode, tpg_pose_t *pose, float *target)
{
    for (size_t joint = 0U; (joint < (size_t)TPG_JOINTS) && ((mode == POSE_JUMPS) || (mode == ANY_POSE)); joint++) {
        pose->ticks[joint] = (mode == POSE_JUMPS) ? (int16_t)(1100 + below(1900U)) : (int16_t)(uint16_t)number();
    }
    for (size_t k = 0U; (k < 3U) && ((mode == TARGET_MOVES) || (mode == ANY_TARGET)); k++) {
        target[k] = (mode == ANY_TARGET) ? any_float() : (float)(below(600U) - 300);
    }
}

int main(int count, char **arguments)
{
    static const uint8_t fs_sources[] = WIDOWX_FS_SOURCES;
    static const uint8_t rs_sources[] = WIDOWX_RS_SOURCES;
    static const tpg_move_t fs_moves[] = WIDOWX_FS_MOVES;
    static const tpg_move_t rs_moves[] = WIDOWX_RS_MOVES;
    static const tpg_policy_t policies[2] = {
        { infer_fs, fs_sources, WIDOWX_FS_SOURCE_COUNT, fs_moves, WIDOWX_FS_ACTIONS },
        { infer_rs, rs_sources, WIDOWX_RS_SOURCE_COUNT, rs_moves, WIDOWX_RS_ACTIONS },
    };
    static const tpg_settings_t settings = { 5U, INFINITY, TPG_GUARD_BOTH };
    static tpg_sac_t sac;
    static tpg_hybrid_t hybrid;
    static tpg_switch_t turn;
    static uint32_t scratch[MODEL_SCRATCH];
    const long episodes = (count > 2) ? strtol(arguments[2], NULL, 10) : 30;

    state = (count > 1) ? strtoull(arguments[1], NULL, 10) : 1U;
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, model, MODEL_WORDS) != TPG_OK)) {
        return 2;
    }
    for (size_t run = 0U; run < (2U * (size_t)MODES); run++) {
        const disturbance_t mode = (disturbance_t)(run % (size_t)MODES);
        unsigned long codes[4] = { 0U, 0U, 0U, 0U };

        if (tpg_hybrid_init(&hybrid, &arm, &policies[run / (size_t)MODES], &sac, &settings, scratch, MODEL_SCRATCH)
            != TPG_OK) {
            return 2;
        }
        for (long episode = 0; episode < episodes; episode++) {
            tpg_pose_t motors;
            tpg_observation_t seen;
            float target[3] = { (float)(below(400U) - 200), (float)(below(400U) - 200), (float)below(300U) };

            if ((tpg_arm_home(&arm, &motors) != TPG_OK) || (tpg_observe(&arm, &motors, target, &seen) != TPG_OK)
                || (tpg_switch_init(&turn, &hybrid, NULL, &seen) != TPG_OK)) {
                return 2;
            }
            for (uint32_t step = 0U; step < STEPS; step++) {
                tpg_pose_t reading = motors;
                tpg_chosen_t chosen = { { { 9, 9, 9, 9 } }, TPG_DRIVER_GRAPH };
                tpg_counts_t before;
                tpg_counts_t after;
                tpg_observation_t again;
                int32_t code;
                int32_t validity;
                const char *wrong;

                garble(mode, &reading, target);
                if ((tpg_observe(&arm, &reading, target, &seen) != TPG_OK) || (tpg_switch_counts(&turn, &before) != TPG_OK)) {
                    return 2;
                }
                code = tpg_hybrid_step(&hybrid, &turn, &reading, target, &again, &chosen);
                if (tpg_switch_counts(&turn, &after) != TPG_OK) {
                    return 2;
                }
                wrong = judge(&seen, code, &chosen, memcmp(&before, &after, sizeof before) == 0);
                if (wrong != NULL) {
                    (void)printf("%s, run %u, episode %ld, step %u: %s (code %d)\n", names[mode], (unsigned)run, episode,
                                 (unsigned)step, wrong, (int)code);
                    return 1;
                }
                codes[(code == TPG_OK) ? 0 : ((code - TPG_BAD_TARGET) + 1)]++;
                if (mode == STUCK) {
                    continue;
                }
                if (tpg_arm_step(&arm, &motors, &chosen.wanted, &motors, &validity) != TPG_OK) {
                    return 2;
                }
            }
        }
        (void)printf("%s %s ok=%lu target=%lu sensor=%lu stuck=%lu\n", (run < (size_t)MODES) ? "fs" : "rs", names[mode],
                     codes[0], codes[1], codes[2], codes[3]);
    }
    return 0;
}
