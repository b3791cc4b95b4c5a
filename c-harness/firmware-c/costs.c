/* Instructions of each profile's C on the same states: those that the fixed-start graph and the random-start graph see. */
#include "fs_balanced.h"
#include "fs_constant.h"
#include "fs_fast.h"
#include "fs_small.h"
#include "platform.h"
#include "problems.h"
#include "report.h"
#include "rs_balanced.h"
#include "rs_constant.h"
#include "rs_fast.h"
#include "rs_small.h"
#include "tpg_runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define LONGEST_STATE 64U
#define PROFILES 4U

typedef uint16_t (*infer_t)(const void *state);

#define INFER(name)                                                                                                    \
    static uint16_t name##_answer(const void *state)                                                                   \
    {                                                                                                                  \
        return (uint16_t)name##_infer(state);                                                                          \
    }

INFER(fs_fast)
INFER(fs_balanced)
INFER(fs_small)
INFER(fs_constant)
INFER(rs_fast)
INFER(rs_balanced)
INFER(rs_small)
INFER(rs_constant)

typedef struct variant {
    const char *name;
    infer_t infer;
    uint32_t instructions;
    uint32_t worst;
} variant_t;

static tpg_arm_t arm;
static tpg_episode_t episode;
static tpg_memo_t memo;
static float state[LONGEST_STATE];
static uint32_t overhead;

/* A call that does nothing: what counting and calling cost. */
static uint16_t nothing(const void *unused)
{
    (void)unused;
    return 0U;
}

static uint32_t cost(infer_t infer, uint16_t *action)
{
    volatile infer_t called = infer;
    infer_t now = called;

    platform_count_from();
    *action = now(state);
    return platform_count();
}

static bool drive(const char *set, variant_t *variants, const uint8_t *sources, size_t source_count,
                  const tpg_move_t *moves, uint32_t actions, const tpg_problem_t *problems)
{
    uint32_t steps = 0U;

    for (uint32_t index = 0U; index < PARTS; index++) {
        int32_t outcome = TPG_RUNNING;
        tpg_observation_t seen;

        if (tpg_episode_init(&episode, &arm, &problems[index]) != TPG_OK) {
            return false;
        }
        while (outcome == TPG_RUNNING) {
            uint16_t action = 0U;

            if ((tpg_episode_observation(&episode, &seen) != TPG_OK)
                || (tpg_observation_state(&arm, &seen, &memo, sources, source_count, state, LONGEST_STATE) != TPG_OK)) {
                return false;
            }
            for (size_t at = 0U; at < PROFILES; at++) {
                uint16_t said;
                const uint32_t gross = cost(variants[at].infer, &said);
                const uint32_t net = (gross > overhead) ? (gross - overhead) : 0U;

                variants[at].instructions += net;
                variants[at].worst = (net > variants[at].worst) ? net : variants[at].worst;
                if ((at > 0U) && (said != action)) {
                    return false;
                }
                action = said;
            }
            if ((action >= actions) || (tpg_episode_advance(&episode, &moves[action], &outcome) != TPG_OK)) {
                return false;
            }
            steps++;
        }
    }
    for (size_t at = 0U; at < PROFILES; at++) {
        report_t line;

        report_begin(&line, "cost ");
        report_word(&line, set);
        report_word(&line, " ");
        report_word(&line, variants[at].name);
        report_unsigned(&line, "actions", steps);
        report_unsigned(&line, "instructions", variants[at].instructions);
        report_unsigned(&line, "worst", variants[at].worst);
        report_print(&line);
    }
    return true;
}

int main(void)
{
    static variant_t fs[PROFILES] = {
        { "fast", fs_fast_answer, 0U, 0U },
        { "balanced", fs_balanced_answer, 0U, 0U },
        { "small", fs_small_answer, 0U, 0U },
        { "constant-time", fs_constant_answer, 0U, 0U },
    };
    static variant_t rs[PROFILES] = {
        { "fast", rs_fast_answer, 0U, 0U },
        { "balanced", rs_balanced_answer, 0U, 0U },
        { "small", rs_small_answer, 0U, 0U },
        { "constant-time", rs_constant_answer, 0U, 0U },
    };
    static const uint8_t fs_sources[] = FS_FAST_SOURCES;
    static const tpg_move_t fs_moves[] = FS_FAST_MOVES;
    static const uint8_t rs_sources[] = RS_FAST_SOURCES;
    static const tpg_move_t rs_moves[] = RS_FAST_MOVES;
    uint16_t ignored;
    report_t line;

    (void)fs_settings;
    (void)rs_settings;
    overhead = cost(nothing, &ignored);
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_memo_init(&memo) != TPG_OK)) {
        return 2;
    }
    if (!drive("fs", fs, fs_sources, FS_FAST_SOURCE_COUNT, fs_moves, FS_FAST_ACTIONS, fs_problems)
        || !drive("rs", rs, rs_sources, RS_FAST_SOURCE_COUNT, rs_moves, RS_FAST_ACTIONS, rs_problems)) {
        return 3;
    }
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
