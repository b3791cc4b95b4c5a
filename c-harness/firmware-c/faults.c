/*
 * Runs the table of sensor faults against a simulated arm, in C: on a host, and on a microcontroller. faults.h is made from
 * the table in src/scenarios.rs; src/faults.rs does the same in Rust.
 *
 * Every step is checked against the contract: the code that the table asks for; with any other code than TPG_OK a move of
 * zero and a switch that is as before; no move of more than 3 ticks.
 */
#include "faults.h"
#include "platform.h"
#include "problems.h"
#include "report.h"
#include "tpg_runtime.h"
#include "widowx_fs.h"
#include "widowx_rs.h"
#include "widowx_sac.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Steps that a reading may be late. */
#define REMEMBERED 32U
/* Steps of an episode that are counted. */
#define STEPS 1707U

static tpg_arm_t arm;
static tpg_sac_t sac;
static tpg_hybrid_t hybrid;
static tpg_switch_t turn;
static uint32_t scratch[WIDOWX_SAC_SCRATCH];

static uint16_t fs_infer(const void *state)
{
    return (uint16_t)widowx_fs_infer(state);
}

static uint16_t rs_infer(const void *state)
{
    return (uint16_t)widowx_rs_infer(state);
}

static const uint8_t fs_sources[] = WIDOWX_FS_SOURCES;
static const tpg_move_t fs_moves[] = WIDOWX_FS_MOVES;
static const uint8_t rs_sources[] = WIDOWX_RS_SOURCES;
static const tpg_move_t rs_moves[] = WIDOWX_RS_MOVES;
static const tpg_policy_t fs_policy = { fs_infer, fs_sources, WIDOWX_FS_SOURCE_COUNT, fs_moves, WIDOWX_FS_ACTIONS };
static const tpg_policy_t rs_policy = { rs_infer, rs_sources, WIDOWX_RS_SOURCE_COUNT, rs_moves, WIDOWX_RS_ACTIONS };

/* The simulated arm: where the motors are, and have been. */
typedef struct world {
    tpg_pose_t motors;
    tpg_pose_t past[REMEMBERED];
    uint32_t steps;
} world_t;

/* The run of a scenario. */
typedef struct run_log {
    uint32_t ok;
    uint32_t target;
    uint32_t sensor;
    uint32_t stuck;
    /* The first step that broke the contract, counted from 1; 0 for none. */
    uint32_t broken;
    /* Code, move and driver of every step. */
    uint64_t hash;
} run_log_t;

static void hash_number(run_log_t *log, uint64_t number)
{
    log->hash = (log->hash ^ number) * 0x100000001b3U;
}

static tpg_pose_t reading_of(const world_t *world, const phase_t *phase, bool odd)
{
    tpg_pose_t pose = world->motors;

    switch (phase->reading) {
    case READING_Late: {
        const uint32_t late = (uint32_t)phase->amount;
        const uint32_t then = (world->steps > late) ? (world->steps - late) : 0U;

        pose = world->past[then % REMEMBERED];
        break;
    }
    case READING_Jump:
        pose.ticks[phase->joint] = (int16_t)(pose.ticks[phase->joint] + phase->amount);
        break;
    case READING_Fixed:
        pose.ticks[phase->joint] = phase->amount;
        break;
    case READING_Flicker:
        if (!odd) {
            pose.ticks[phase->joint] = phase->amount;
        }
        break;
    default:
        break;
    }
    return pose;
}

/* The motors do what they were told, as far as the phase lets them. */
static bool advance(world_t *world, const phase_t *phase, const tpg_move_t *wanted)
{
    tpg_move_t done = *wanted;
    int32_t validity;

    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        if ((phase->reading == READING_Stuck) || ((phase->reading == READING_JointStuck) && (phase->joint == joint))) {
            done.ticks[joint] = 0;
        }
    }
    if (tpg_arm_step(&arm, &world->motors, &done, &world->motors, &validity) != TPG_OK) {
        return false;
    }
    world->steps++;
    world->past[world->steps % REMEMBERED] = world->motors;
    return true;
}

/* Makes an observation wrong as a caller might; false in the other phases. */
static bool garble(const phase_t *phase, tpg_observation_t *seen)
{
    bool garbled = true;

    switch (phase->reading) {
    case READING_HandNan:
        seen->hand[1] = NAN;
        break;
    case READING_DifferenceInfinite:
        seen->difference[2] = -INFINITY;
        break;
    case READING_HandOff:
        seen->hand[0] += 50.0F;
        break;
    case READING_HandInfinite:
        seen->hand[0] = INFINITY;
        seen->difference[0] = -INFINITY;
        break;
    default:
        garbled = false;
        break;
    }
    return garbled;
}

static void target_of(const phase_t *phase, float target[3])
{
    static const float good[3] = GOOD_TARGET;
    static const float far[3] = FAR_TARGET;

    for (size_t k = 0U; k < 3U; k++) {
        target[k] = (phase->target == TARGET_Far) ? far[k] : good[k];
    }
    if (phase->target == TARGET_Nan) {
        target[1] = NAN;
    } else if (phase->target == TARGET_Infinite) {
        target[0] = INFINITY;
    } else if (phase->target == TARGET_Huge) {
        target[2] = -1e38F;
    } else {
        /* It is as it is. */
    }
}

/* One step of the loop: its code, and the action. */
static int32_t control(const scenario_t *scenario, const phase_t *phase, const tpg_pose_t *motors, bool *begun,
                       tpg_chosen_t *chosen)
{
    static const tpg_chosen_t nothing = { { { 0, 0, 0, 0 } }, TPG_DRIVER_GRAPH };
    tpg_observation_t seen;
    float target[3];

    *chosen = nothing;
    target_of(phase, target);
    if (tpg_observe(&arm, motors, target, &seen) != TPG_OK) {
        return TPG_STATE;
    }
    if (!*begun) {
        const int32_t code = tpg_switch_init(&turn, &hybrid, &scenario->watch, &seen);

        if (code != TPG_OK) {
            return code;
        }
        *begun = true;
    }
    if (garble(phase, &seen)) {
        return tpg_hybrid_decide(&hybrid, &turn, &seen, chosen);
    }
    return tpg_hybrid_step(&hybrid, &turn, motors, target, &seen, chosen);
}

/* No joint moves by more ticks than that. */
static bool small(const tpg_move_t *wanted, int8_t most)
{
    bool all = true;

    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        const int8_t ticks = wanted->ticks[joint];

        all = all && (ticks >= -most) && (ticks <= most);
    }
    return all;
}

static bool same_counts(const tpg_counts_t *a, const tpg_counts_t *b)
{
    bool same = (a->graph_actions == b->graph_actions) && (a->network_actions == b->network_actions)
        && (a->hand_backs == b->hand_backs);

    for (size_t cause = 0U; cause < (size_t)TPG_CAUSES; cause++) {
        same = same && (a->hand_overs[cause] == b->hand_overs[cause]);
    }
    return same;
}

static void note(run_log_t *log, int32_t code, const tpg_chosen_t *chosen)
{
    switch (code) {
    case TPG_OK:
        log->ok++;
        break;
    case TPG_BAD_TARGET:
        log->target++;
        break;
    case TPG_BAD_SENSOR:
        log->sensor++;
        break;
    default:
        log->stuck++;
        break;
    }
    hash_number(log, (uint32_t)code);
    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        hash_number(log, (uint8_t)chosen->wanted.ticks[joint]);
    }
    hash_number(log, (chosen->driver == TPG_DRIVER_NETWORK) ? 1U : 0U);
}

static bool run(const scenario_t *scenario)
{
    static const tpg_counts_t none = { 0 };
    tpg_counts_t counts = none;
    world_t world;
    run_log_t log = { 0U, 0U, 0U, 0U, 0U, 0xcbf29ce484222325U };
    uint32_t step = 0U;
    int32_t before = TPG_OK;
    bool begun = false;
    report_t line;

    if (tpg_arm_home(&arm, &world.motors) != TPG_OK) {
        return false;
    }
    world.steps = 0U;
    for (size_t index = 0U; index < REMEMBERED; index++) {
        world.past[index] = world.motors;
    }
    for (size_t at = 0U; at < scenario->count; at++) {
        const phase_t *phase = &scenario->phases[at];

        for (uint32_t index = 0U; index < phase->steps; index++) {
            const bool odd = (index % 2U) == 1U;
            const tpg_pose_t motors = reading_of(&world, phase, odd);
            const int32_t due = (odd && (phase->reading == READING_Flicker)) ? TPG_OK : phase->code;
            tpg_counts_t after = none;
            tpg_chosen_t chosen;
            int32_t code;
            bool right;

            if (phase->resume && (index == 0U)) {
                (void)tpg_switch_resume(&turn, &motors);
            }
            code = control(scenario, phase, &motors, &begun, &chosen);
            if (begun && (tpg_switch_counts(&turn, &after) != TPG_OK)) {
                return false;
            }
            step++;
            right = (code == due) || ((index < phase->within) && ((code == before) || (code == TPG_OK)));
            right = right && small(&chosen.wanted, (code == TPG_OK) ? 3 : 0);
            right = right && ((code == TPG_OK) || same_counts(&counts, &after));
            if (!right && (log.broken == 0U)) {
                log.broken = step;
            }
            counts = after;
            note(&log, code, &chosen);
            if (!advance(&world, phase, &chosen.wanted)) {
                return false;
            }
        }
        before = phase->code;
    }
    report_begin(&line, "fault ");
    report_word(&line, scenario->name);
    report_unsigned(&line, "ok", log.ok);
    report_unsigned(&line, "target", log.target);
    report_unsigned(&line, "sensor", log.sensor);
    report_unsigned(&line, "stuck", log.stuck);
    report_unsigned(&line, "broken", log.broken);
    report_unsigned(&line, "graph", counts.graph_actions);
    report_unsigned(&line, "network", counts.network_actions);
    report_number(&line, "base", world.motors.ticks[0]);
    report_number(&line, "shoulder", world.motors.ticks[1]);
    report_number(&line, "elbow", world.motors.ticks[2]);
    report_number(&line, "wrist", world.motors.ticks[3]);
    report_hexadecimal(&line, "log", log.hash);
    report_print(&line);
    return true;
}

static bool join(const tpg_policy_t *policy, const tpg_settings_t *settings)
{
    return tpg_hybrid_init(&hybrid, &arm, policy, &sac, settings, scratch, WIDOWX_SAC_SCRATCH) == TPG_OK;
}

/* Instructions of whole control steps, checks and observation included. */
static bool costs(const char *name, const tpg_problem_t *problems)
{
    uint32_t overhead;
    uint32_t steps = 0U;
    uint32_t sum = 0U;
    uint32_t worst = 0U;
    report_t line;

    platform_count_from();
    overhead = platform_count();
    for (uint32_t index = 0U; index < PARTS; index++) {
        const tpg_problem_t *problem = &problems[index];
        tpg_pose_t motors = problem->start;
        tpg_observation_t seen;
        float distance;

        if ((tpg_observe(&arm, &motors, problem->target, &seen) != TPG_OK)
            || (tpg_switch_init(&turn, &hybrid, NULL, &seen) != TPG_OK)) {
            return false;
        }
        for (uint32_t step = 0U; step < STEPS; step++) {
            tpg_chosen_t chosen;
            int32_t validity;
            uint32_t count;

            platform_count_from();
            if (tpg_hybrid_step(&hybrid, &turn, &motors, problem->target, &seen, &chosen) != TPG_OK) {
                return false;
            }
            count = platform_count() - overhead;
            steps++;
            sum += count;
            worst = (count > worst) ? count : worst;
            if ((tpg_observation_distance(&seen, &distance) != TPG_OK)
                || (tpg_arm_step(&arm, &motors, &chosen.wanted, &motors, &validity) != TPG_OK)) {
                return false;
            }
            if (distance < problem->tolerance) {
                break;
            }
        }
    }
    report_begin(&line, name);
    report_unsigned(&line, "actions", steps);
    report_unsigned(&line, "instructions", sum);
    report_unsigned(&line, "worst", worst);
    report_print(&line);
    return true;
}

int main(void)
{
    report_t line;

    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, widowx_sac, WIDOWX_SAC_WORDS) != TPG_OK)
        || !join(&fs_policy, &fs_settings)) {
        return 2;
    }
    for (size_t at = 0U; at < SCENARIOS; at++) {
        if (!run(&scenarios[at])) {
            return 3;
        }
    }
    if (!costs("cost fs step", fs_problems) || !join(&rs_policy, &rs_settings) || !costs("cost rs step", rs_problems)) {
        return 4;
    }
    report_begin(&line, "done");
    report_print(&line);
    return 0;
}
