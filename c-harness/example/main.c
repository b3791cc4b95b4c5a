/*
 * A control loop: a generated policy drives, a network helps, the arm goes to a target.
 *
 * On a real arm read_motors and write_motors talk to the servos; here they are a model of it.
 */
#include "platform.h"
#include "report.h"
#include "tpg_runtime.h"
#include "widowx_fs.h"
#include "widowx_sac.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define TOLERANCE_MM 3.0F
#define MAX_ACTIONS 1707U
/* Readings in a row that the library may refuse before the loop gives up. */
#define MAX_FAULTS 10U

/* All memory there is, beside the stack. */
static tpg_arm_t arm;
static tpg_sac_t sac;
static tpg_hybrid_t hybrid;
static tpg_switch_t turn;
static uint32_t scratch[WIDOWX_SAC_SCRATCH];

/* The generated policy, for the runtime. */
static uint16_t infer(const void *state)
{
    return (uint16_t)widowx_fs_infer(state);
}

static const uint8_t sources[] = WIDOWX_FS_SOURCES;
static const tpg_move_t moves[] = WIDOWX_FS_MOVES;
static const tpg_policy_t policy = { infer, sources, WIDOWX_FS_SOURCE_COUNT, moves, WIDOWX_FS_ACTIONS };
/* As generated/widowx-fs/hybrid.toml has them. */
static const tpg_settings_t settings = { 5U, INFINITY, TPG_GUARD_BOTH };

/* Positions of the model's motors. */
static tpg_pose_t motors;

static tpg_pose_t read_motors(void)
{
    return motors;
}

static bool write_motors(const tpg_move_t *wanted)
{
    int32_t validity;

    return (tpg_arm_step(&arm, &motors, wanted, &motors, &validity) == TPG_OK) && (validity == TPG_VALID);
}

/* Goes to a target; answers true if the hand is there, and counts the actions. */
static bool go_to(const float target[3], uint32_t *actions)
{
    tpg_pose_t pose = read_motors();
    tpg_observation_t seen;
    uint32_t faults = 0U;

    *actions = 0U;
    if ((tpg_observe(&arm, &pose, target, &seen) != TPG_OK) || (tpg_switch_init(&turn, &hybrid, NULL, &seen) != TPG_OK)) {
        return false;
    }
    while ((*actions < MAX_ACTIONS) && (faults < MAX_FAULTS)) {
        tpg_chosen_t chosen;
        float distance;

        pose = read_motors();
        if (tpg_hybrid_step(&hybrid, &turn, &pose, target, &seen, &chosen) != TPG_OK) {
            /* TPG_BAD_TARGET, TPG_BAD_SENSOR, TPG_STUCK: nothing moves, the next reading may be better. */
            faults++;
            continue;
        }
        faults = 0U;
        if (tpg_observation_distance(&seen, &distance) != TPG_OK) {
            return false;
        }
        if (distance < TOLERANCE_MM) {
            return true;
        }
        if (!write_motors(&chosen.wanted)) {
            return false;
        }
        (*actions)++;
    }
    return false;
}

int main(void)
{
    static const float targets[3][3] = {
        { -23.0F, -377.0F, 322.0F }, { 195.0F, 350.0F, 284.0F }, { -378.0F, 13.0F, 73.0F },
    };
    report_t line;
    bool good = true;

    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, widowx_sac, WIDOWX_SAC_WORDS) != TPG_OK)
        || (tpg_hybrid_init(&hybrid, &arm, &policy, &sac, &settings, scratch, WIDOWX_SAC_SCRATCH) != TPG_OK)) {
        return 2;
    }
    for (uint32_t index = 0U; index < 3U; index++) {
        uint32_t actions = 0U;
        bool there = (tpg_arm_home(&arm, &motors) == TPG_OK) && go_to(targets[index], &actions);

        report_begin(&line, there ? "reached" : "missed");
        report_unsigned(&line, "target", index);
        report_unsigned(&line, "actions", actions);
        report_print(&line);
        good = good && there;
    }
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return good ? 0 : 1;
}
