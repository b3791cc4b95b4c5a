/*
 * Drives the simulated arm to a list of targets and prints a line an episode: by the hybrid, and by each of its parts
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
static tpg_hybrid_episode_t hybrid_episode;
static tpg_episode_t episode;
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
    const tpg_problem_t *problems;
    uint32_t count;
} run_t;

/* Result of an episode. */
typedef struct result {
    int32_t outcome;
    uint32_t actions;
    uint32_t instructions;
    uint32_t worst;
    uint64_t poses;
    tpg_counts_t counts;
    tpg_observation_t seen;
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

/* One action of the hybrid: what is between the marks is what a controller computes from one reading of the motors. */
static bool hybrid_step(result_t *result)
{
    tpg_chosen_t chosen;

    platform_count_from();
    if (tpg_hybrid_episode_decide(&hybrid_episode, &chosen) != TPG_OK) {
        return false;
    }
    counted(result, platform_count());
    return (tpg_hybrid_episode_act(&hybrid_episode, &chosen, &result->outcome) == TPG_OK)
        && (tpg_hybrid_episode_observation(&hybrid_episode, &result->seen) == TPG_OK);
}

/* One action of a part alone. */
static bool single_step(const run_t *run, result_t *result)
{
    tpg_move_t wanted;
    int32_t code;

    platform_count_from();
    if (run->controller == GRAPH) {
        code = tpg_policy_decide(run->policy, &arm, &result->seen, &memo, &wanted);
    } else {
        code = tpg_sac_decide(&sac, &arm, &result->seen, scratch, WIDOWX_SAC_SCRATCH, &wanted);
    }
    counted(result, platform_count());
    return (code == TPG_OK) && (tpg_episode_advance(&episode, &wanted, &result->outcome) == TPG_OK)
        && (tpg_episode_observation(&episode, &result->seen) == TPG_OK);
}

static bool begin(const run_t *run, const tpg_problem_t *problem, result_t *result)
{
    static const result_t empty = { 0 };

    *result = empty;
    result->poses = 0xcbf29ce484222325U;
    if (run->controller == HYBRID) {
        return (tpg_hybrid_init(&hybrid, &arm, run->policy, &sac, run->settings, scratch, WIDOWX_SAC_SCRATCH) == TPG_OK)
            && (tpg_hybrid_episode_init(&hybrid_episode, &hybrid, problem) == TPG_OK);
    }
    return (tpg_memo_init(&memo) == TPG_OK) && (tpg_episode_init(&episode, &arm, problem) == TPG_OK)
        && (tpg_episode_observation(&episode, &result->seen) == TPG_OK);
}

static bool drive(const run_t *run, const tpg_problem_t *problem, result_t *result)
{
    if (!begin(run, problem, result)) {
        return false;
    }
    while (result->outcome == TPG_RUNNING) {
        if (!((run->controller == HYBRID) ? hybrid_step(result) : single_step(run, result))) {
            return false;
        }
        result->actions++;
        result->poses = hashed(result->poses, &result->seen.pose);
    }
    if (run->controller == HYBRID) {
        return tpg_hybrid_episode_counts(&hybrid_episode, &result->counts) == TPG_OK;
    }
    return true;
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
    report_number(&line, "outcome", result->outcome);
    report_unsigned(&line, "actions", result->actions);
    report_unsigned(&line, "graph", counts->graph_actions);
    report_unsigned(&line, "network", counts->network_actions);
    report_unsigned(&line, "switches",
                    counts->hand_overs[0] + counts->hand_overs[1] + counts->hand_overs[2] + counts->hand_overs[3]);
    report_number(&line, "base", result->seen.pose.ticks[0]);
    report_number(&line, "shoulder", result->seen.pose.ticks[1]);
    report_number(&line, "elbow", result->seen.pose.ticks[2]);
    report_number(&line, "wrist", result->seen.pose.ticks[3]);
    report_hexadecimal(&line, "poses", result->poses);
    report_unsigned(&line, "instructions", result->instructions);
    report_unsigned(&line, "worst", result->worst);
    report_print(&line);
}

typedef struct decision {
    tpg_chosen_t chosen;
    int32_t code;
} decision_t;

/* One decision of the hybrid as a function of an argument, whose stack can be measured. */
static void hybrid_decides(void *argument)
{
    decision_t *decision = argument;

    decision->code = tpg_hybrid_episode_decide(&hybrid_episode, &decision->chosen);
}

/* The most bytes of stack that a decision takes in some episodes. */
static bool stack_of_decisions(const run_t *run)
{
    report_t line;
    uint32_t deepest = 0U;

    for (uint32_t index = 0U; index < 8U; index++) {
        result_t result;

        if (!begin(run, &run->problems[index], &result)) {
            return false;
        }
        while (result.outcome == TPG_RUNNING) {
            decision_t decision;
            const uint32_t stack = platform_stack_of(hybrid_decides, &decision);

            deepest = (stack > deepest) ? stack : deepest;
            if ((decision.code != TPG_OK)
                || (tpg_hybrid_episode_act(&hybrid_episode, &decision.chosen, &result.outcome) != TPG_OK)) {
                return false;
            }
        }
    }
    report_begin(&line, "decision ");
    report_word(&line, run->set);
    report_unsigned(&line, "stack", deepest);
    report_print(&line);
    return true;
}

/* Counts the work of a controller beside its decision: it observes the arm and tells the switch. */
static bool observing(void)
{
    tpg_observation_t seen;
    tpg_switch_t turn;
    int32_t cause;
    const tpg_chosen_t chosen = { { { 3, 0, 0, 0 } }, TPG_DRIVER_GRAPH };
    report_t line;
    uint32_t observe;
    uint32_t acted;
    const tpg_problem_t *problem = &rs_problems[0];

    platform_count_from();
    if (tpg_observe(&arm, &problem->start, problem->target, &seen) != TPG_OK) {
        return false;
    }
    observe = platform_count() - overhead;
    if ((tpg_hybrid_init(&hybrid, &arm, &rs_policy, &sac, &rs_settings, scratch, WIDOWX_SAC_SCRATCH) != TPG_OK)
        || (tpg_switch_init(&turn, &hybrid, NULL, &seen) != TPG_OK)) {
        return false;
    }
    platform_count_from();
    if (tpg_switch_acted(&turn, &chosen, &seen, &cause) != TPG_OK) {
        return false;
    }
    acted = platform_count() - overhead;
    report_begin(&line, "around");
    report_unsigned(&line, "observe", observe);
    report_unsigned(&line, "switch", acted);
    report_print(&line);
    return true;
}

int main(void)
{
    static const run_t runs[] = {
        { HYBRID, "hybrid", "fs", &fs_policy, &fs_settings, fs_problems, PROBLEMS },
        { HYBRID, "hybrid", "rs", &rs_policy, &rs_settings, rs_problems, PROBLEMS },
        { GRAPH, "graph", "fs", &fs_policy, NULL, fs_problems, PARTS },
        { GRAPH, "graph", "rs", &rs_policy, NULL, rs_problems, PARTS },
        { NETWORK, "network", "fs", NULL, NULL, fs_problems, PARTS },
        { NETWORK, "network", "rs", NULL, NULL, rs_problems, PARTS },
    };
    report_t line;

    platform_count_from();
    overhead = platform_count();
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, widowx_sac, WIDOWX_SAC_WORDS) != TPG_OK)
        || (widowx_fs_selftest() != 0U) || (widowx_rs_selftest() != 0U) || !observing()) {
        return 2;
    }
    for (size_t at = 0U; at < (sizeof(runs) / sizeof(runs[0])); at++) {
        if ((runs[at].controller == HYBRID) && !stack_of_decisions(&runs[at])) {
            return 3;
        }
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
