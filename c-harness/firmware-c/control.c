/*
 * Drives a model of the arm to a list of targets and prints a line an episode: by the hybrid, and by each of its parts
 * alone. The same program runs on a microcontroller and on a host; only platform.h differs.
 */
#include "platform.h"
#include "problems.h"
#include "report.h"
#include "tpg_runtime.h"
#include "widowx_fs.h"
#include "widowx_rs.h"
#include "widowx_sac.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* All memory there is, beside the stack. */
static tpg_arm_t arm;
static tpg_sac_t sac;
static uint32_t scratch[WIDOWX_SAC_SCRATCH];
static tpg_hybrid_t hybrid;
static tpg_switch_t turn;
static tpg_memo_t memo;
static uint32_t overhead;

static const uint8_t fs_sources[] = WIDOWX_FS_SOURCES;
static const tpg_move_t fs_moves[] = WIDOWX_FS_MOVES;
static const uint8_t rs_sources[] = WIDOWX_RS_SOURCES;
static const tpg_move_t rs_moves[] = WIDOWX_RS_MOVES;

static uint16_t fs_infer(const void *state)
{
    return (uint16_t)widowx_fs_infer(state);
}

static uint16_t rs_infer(const void *state)
{
    return (uint16_t)widowx_rs_infer(state);
}

static const tpg_policy_t fs_policy = { fs_infer, fs_sources, WIDOWX_FS_SOURCE_COUNT, fs_moves, WIDOWX_FS_ACTIONS };
static const tpg_policy_t rs_policy = { rs_infer, rs_sources, WIDOWX_RS_SOURCE_COUNT, rs_moves, WIDOWX_RS_ACTIONS };

typedef enum controller { HYBRID, GRAPH, NETWORK } controller_t;

typedef struct run {
    controller_t controller;
    const char *name;
    const char *set;
    const tpg_policy_t *policy;
    const tpg_settings_t *settings;
    const problem_t *problems;
    uint32_t count;
    uint32_t most_actions;
} run_t;

/* Result of an episode. */
typedef struct result {
    uint32_t reached;
    uint32_t actions;
    uint32_t instructions;
    uint32_t worst;
    uint64_t poses;
    tpg_counts_t counts;
    tpg_pose_t motors;
} result_t;

/* FNV-1a over the motor positions of every step. */
static uint64_t hashed(uint64_t before, const tpg_pose_t *pose)
{
    uint64_t hash = before;

    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        const uint32_t ticks = (uint16_t)pose->ticks[joint];
        hash = (hash ^ (ticks & 0xffU)) * 0x100000001b3U;
        hash = (hash ^ (ticks >> 8)) * 0x100000001b3U;
    }
    return hash;
}

static void counted(result_t *result, uint32_t instructions)
{
    const uint32_t net = (instructions > overhead) ? (instructions - overhead) : 0U;

    result->instructions += net;
    result->worst = (net > result->worst) ? net : result->worst;
}

/* From a reading of the motors to a move: what a controller computes. */
static int32_t decide(const run_t *run, const float *target, const tpg_pose_t *motors, tpg_observation_t *seen,
                      tpg_move_t *wanted)
{
    int32_t code;

    if (run->controller == HYBRID) {
        tpg_chosen_t chosen;

        code = tpg_hybrid_step(&hybrid, &turn, motors, target, seen, &chosen);
        *wanted = chosen.wanted;
    } else {
        code = tpg_observe(&arm, motors, target, seen);
        if (code == TPG_OK) {
            code = (run->controller == GRAPH)
                ? tpg_policy_decide(run->policy, &arm, seen, &memo, wanted)
                : tpg_sac_decide(&sac, &arm, seen, scratch, WIDOWX_SAC_SCRATCH, wanted);
        }
    }
    return code;
}

static bool begin(const run_t *run, const problem_t *problem)
{
    tpg_observation_t seen;

    if (run->controller != HYBRID) {
        return tpg_memo_init(&memo) == TPG_OK;
    }
    return (tpg_hybrid_init(&hybrid, &arm, run->policy, &sac, run->settings, scratch, WIDOWX_SAC_SCRATCH) == TPG_OK)
        && (tpg_observe(&arm, &problem->start, problem->target, &seen) == TPG_OK)
        && (tpg_switch_init(&turn, &hybrid, NULL, &seen) == TPG_OK);
}

/* Goes until the hand is at the target, a move is not valid or moves nothing, or time is up. */
static bool drive(const run_t *run, const problem_t *problem, result_t *result)
{
    static const result_t empty = { 0 };
    int32_t validity = TPG_VALID;
    bool still = false;

    *result = empty;
    result->poses = 0xcbf29ce484222325U;
    result->motors = problem->start;
    if (!begin(run, problem)) {
        return false;
    }
    while ((result->reached == 0U) && (validity == TPG_VALID) && !still && (result->actions < run->most_actions)) {
        tpg_observation_t seen;
        tpg_move_t wanted;
        float distance;
        int32_t code;

        platform_count_from();
        code = decide(run, problem->target, &result->motors, &seen, &wanted);
        counted(result, platform_count());
        if ((code != TPG_OK) || (tpg_observation_distance(&seen, &distance) != TPG_OK)) {
            return false;
        }
        if (distance < TOLERANCE_MM) {
            result->reached = 1U;
        } else if (tpg_arm_step(&arm, &result->motors, &wanted, &result->motors, &validity) != TPG_OK) {
            return false;
        } else {
            /* The motors have moved. */
        }
        still = (run->controller != HYBRID) && (wanted.ticks[0] == 0) && (wanted.ticks[1] == 0)
            && (wanted.ticks[2] == 0) && (wanted.ticks[3] == 0);
        result->actions++;
        result->poses = hashed(result->poses, &result->motors);
    }
    return (run->controller != HYBRID) || (tpg_switch_counts(&turn, &result->counts) == TPG_OK);
}

static void tell(const run_t *run, uint32_t index, const result_t *result)
{
    report_t line;
    const tpg_counts_t *counts = &result->counts;

    report_begin(&line, "episode ");
    report_word(&line, run->set);
    report_word(&line, " ");
    report_word(&line, run->name);
    report_unsigned(&line, "index", index);
    report_unsigned(&line, "reached", result->reached);
    report_unsigned(&line, "actions", result->actions);
    report_unsigned(&line, "graph", counts->graph_actions);
    report_unsigned(&line, "network", counts->network_actions);
    report_unsigned(&line, "switches",
                    counts->hand_overs[0] + counts->hand_overs[1] + counts->hand_overs[2] + counts->hand_overs[3]);
    report_number(&line, "base", result->motors.ticks[0]);
    report_number(&line, "shoulder", result->motors.ticks[1]);
    report_number(&line, "elbow", result->motors.ticks[2]);
    report_number(&line, "wrist", result->motors.ticks[3]);
    report_hexadecimal(&line, "poses", result->poses);
    report_unsigned(&line, "instructions", result->instructions);
    report_unsigned(&line, "worst", result->worst);
    report_print(&line);
}

int main(void)
{
    static const run_t runs[] = {
        { HYBRID, "hybrid", "fs", &fs_policy, &fs_settings, fs_problems, PROBLEMS, FS_ACTIONS },
        { HYBRID, "hybrid", "rs", &rs_policy, &rs_settings, rs_problems, PROBLEMS, RS_ACTIONS },
        { GRAPH, "graph", "fs", &fs_policy, NULL, fs_problems, PARTS, FS_ACTIONS },
        { GRAPH, "graph", "rs", &rs_policy, NULL, rs_problems, PARTS, RS_ACTIONS },
        { NETWORK, "network", "fs", NULL, NULL, fs_problems, PARTS, FS_ACTIONS },
        { NETWORK, "network", "rs", NULL, NULL, rs_problems, PARTS, RS_ACTIONS },
    };
    report_t line;

    platform_count_from();
    overhead = platform_count();
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, widowx_sac, WIDOWX_SAC_WORDS) != TPG_OK)
        || (widowx_fs_selftest() != 0U) || (widowx_rs_selftest() != 0U)) {
        return 2;
    }
    for (size_t at = 0U; at < (sizeof(runs) / sizeof(runs[0])); at++) {
        for (uint32_t index = 0U; index < runs[at].count; index++) {
            result_t result;
            if (!drive(&runs[at], &runs[at].problems[index], &result)) {
                return 3;
            }
            tell(&runs[at], index, &result);
        }
    }
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
