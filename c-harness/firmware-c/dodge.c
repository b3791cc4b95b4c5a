/*
 * The control step among balls in C: recorded scenes, in which every motor position is as on the host, and drawn ones with three
 * balls, which are counted. balls.c is made from the committed scenes by src/dodge.rs.
 */
#include "dodge.h"
#include "hash.h"
#include "platform.h"
#include "report.h"
#include "scenes.h"
#include "tpg_runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TASKS 60U
#define STEPS 150U

static tpg_arm_t arm;
static tpg_body_t body;
static tpg_dodger_t dodger;
static uint32_t overhead;

static const uint8_t sources[] = { TPG_SOURCE_LEFT,  TPG_SOURCE_NEAR,     TPG_SOURCE_SECOND,
                                   TPG_SOURCE_AHEAD, TPG_SOURCE_PROGRESS, TPG_SOURCE_DETOUR };
/* The graph's actions are all behaviours, in their order; and those, one after another. */
static const uint8_t behaviours[TPG_BEHAVIOURS] = { 0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 14U };

typedef struct tally {
    uint32_t actions;
    uint32_t instructions;
    uint32_t worst;
    uint64_t poses;
} tally_t;

/* The action that the drawn tasks take instead of the graph's in every other step. */
static uint32_t turn;

static uint16_t graph(const void *state)
{
    return (uint16_t)dodge_infer(state);
}

static uint16_t in_turn(const void *state)
{
    const uint16_t action = (uint16_t)dodge_infer(state);

    return ((turn % 2U) == 0U) ? action : (uint16_t)((turn / 2U) % (uint32_t)TPG_BEHAVIOURS);
}

static const tpg_dodge_policy_t shipped = { graph, sources, sizeof sources, behaviours, TPG_BEHAVIOURS };
static const tpg_dodge_policy_t any = { in_turn, sources, sizeof sources, behaviours, TPG_BEHAVIOURS };

/* One step, counted; the motors do what they were told. */
static bool advance(tpg_pose_t *motors, const tpg_ball_t *seen, size_t count, tally_t *tally)
{
    tpg_dodge_t chosen;
    uint32_t instructions;
    int32_t validity;
    int32_t code;

    platform_count_from();
    code = tpg_dodger_step(&dodger, motors, seen, count, &chosen);
    instructions = platform_count();
    instructions = (instructions > overhead) ? (instructions - overhead) : 0U;
    if ((code != TPG_OK) || (tpg_arm_step(&arm, motors, &chosen.wanted, motors, &validity) != TPG_OK)
        || (validity != TPG_VALID)) {
        return false;
    }
    tally->actions++;
    tally->instructions += instructions;
    tally->worst = (instructions > tally->worst) ? instructions : tally->worst;
    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        const uint32_t ticks = (uint16_t)motors->ticks[joint];

        tally->poses = hash_bits(tally->poses, ticks & 0xffU);
        tally->poses = hash_bits(tally->poses, ticks >> 8);
    }
    return true;
}

static void tell(const char *words, const tally_t *tally)
{
    report_t line;

    report_begin(&line, words);
    report_unsigned(&line, "actions", tally->actions);
    report_unsigned(&line, "instructions", tally->instructions);
    report_unsigned(&line, "worst", tally->worst);
    report_hexadecimal(&line, "hash", tally->poses);
    report_print(&line);
}

/* The balls of a scene at a step: where they are, and how far they went since the step before. */
static void observe(const scene_t *scene, uint32_t step, tpg_ball_t *seen)
{
    for (uint32_t ball = 0U; ball < scene->balls; ball++) {
        const float *before = centres[scene->first + (step * scene->balls) + ball];
        const float *now = centres[scene->first + ((step + 1U) * scene->balls) + ball];

        for (size_t axis = 0U; axis < 3U; axis++) {
            seen[ball].at[axis] = now[axis];
            seen[ball].velocity[axis] = now[axis] - before[axis];
        }
        seen[ball].radius = scene->radii[ball];
    }
}

static bool recorded(tally_t *tally)
{
    for (size_t at = 0U; at < (size_t)SCENES; at++) {
        const scene_t *scene = &scenes[at];
        tpg_pose_t motors;
        tpg_ball_t seen[TPG_BALLS];

        motors = scene->start;
        observe(scene, 0U, seen);
        if (tpg_dodger_init(&dodger, &body, &shipped, NULL, NULL, scene->goals, scene->goal_count, &motors, seen,
                            scene->balls) != TPG_OK) {
            return false;
        }
        for (uint32_t step = 0U; step < scene->steps; step++) {
            observe(scene, step, seen);
            if (!advance(&motors, seen, scene->balls, tally)) {
                return false;
            }
        }
    }
    return true;
}

/* Numerical Recipes' generator: states for counting need no better one. */
static float between(uint32_t *state, float low, float high)
{
    *state = (*state * 1664525U) + 1013904223U;
    return low + (((high - low) * (float)(*state >> 8)) / 16777216.0F);
}

/* A pose without a collision. */
static bool draw_pose(uint32_t *state, tpg_pose_t *pose)
{
    int32_t collision = TPG_COLLISION_TABLE;

    while (collision != TPG_VALID) {
        for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
            pose->ticks[joint] = (int16_t)between(state, 1100.0F, 3000.0F);
        }
        if (tpg_arm_collision(&arm, pose, &collision) != TPG_OK) {
            return false;
        }
    }
    return true;
}

static void draw_ball(uint32_t *state, tpg_ball_t *ball)
{
    static const float low[6] = { -350.0F, -350.0F, 30.0F, -1.0F, -1.0F, -0.5F };
    static const float high[6] = { 350.0F, 350.0F, 400.0F, 1.0F, 1.0F, 0.5F };

    for (size_t axis = 0U; axis < 3U; axis++) {
        ball->at[axis] = between(state, low[axis], high[axis]);
    }
    for (size_t axis = 0U; axis < 3U; axis++) {
        ball->velocity[axis] = between(state, low[3U + axis], high[3U + axis]);
    }
    ball->radius = between(state, 30.0F, 60.0F);
}

static bool drawn(tally_t *tally)
{
    uint32_t state = 1U;

    for (uint32_t task = 0U; task < TASKS; task++) {
        tpg_pose_t motors;
        tpg_pose_t goals[TPG_GOALS];
        tpg_ball_t seen[TPG_BALLS];
        bool good = draw_pose(&state, &motors);

        for (size_t goal = 0U; goal < (size_t)TPG_GOALS; goal++) {
            good = draw_pose(&state, &goals[goal]) && good;
        }
        for (size_t ball = 0U; ball < (size_t)TPG_BALLS; ball++) {
            draw_ball(&state, &seen[ball]);
        }
        if (!good
            || (tpg_dodger_init(&dodger, &body, &any, NULL, NULL, goals, TPG_GOALS, &motors, seen, TPG_BALLS) != TPG_OK)) {
            return false;
        }
        for (turn = 0U; turn < STEPS; turn++) {
            for (size_t ball = 0U; ball < (size_t)TPG_BALLS; ball++) {
                for (size_t axis = 0U; axis < 3U; axis++) {
                    seen[ball].at[axis] += seen[ball].velocity[axis];
                }
            }
            if (!advance(&motors, seen, TPG_BALLS, tally)) {
                return false;
            }
        }
    }
    return true;
}

int main(void)
{
    tally_t of_scenes = { 0U, 0U, 0U, HASH_START };
    tally_t of_drawn = { 0U, 0U, 0U, HASH_START };
    report_t line;

    platform_count_from();
    overhead = platform_count();
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_body_init(&body, &arm, NULL) != TPG_OK)) {
        return 2;
    }
    if (!recorded(&of_scenes)) {
        return 3;
    }
    if (!drawn(&of_drawn)) {
        return 4;
    }
    tell("cost dodge scenes", &of_scenes);
    tell("cost dodge any behaviour", &of_drawn);
    report_begin(&line, "done");
    report_unsigned(&line, "stack", platform_stack_used());
    report_print(&line);
    return 0;
}
