/* Every function of tpg_runtime.h with good pointers and with each of the bad ones: NULL, misaligned, too short, not
 * initialised. Also C++11. Prints the first check that failed. */
#include "tpg_runtime.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "model.h"

static int failures = 0;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            (void)printf("line %d: %s\n", __LINE__, #condition);                                                       \
            failures++;                                                                                                \
        }                                                                                                              \
    } while (0)

/* A pointer that no type but char is aligned for. */
static union {
    uint64_t words[80];
    unsigned char bytes[640];
} memory;

#define MISALIGNED(type) ((type *)(void *)&memory.bytes[1])

/* A policy that turns the base towards the target's side. */
static uint16_t turn_base(const void *state)
{
    const float *difference = (const float *)state;

    return (uint16_t)((difference[0] < 0.0F) ? 0 : 1);
}

static uint16_t never_moves(const void *state)
{
    (void)state;
    return 9U;
}

static const uint8_t sources[1] = { TPG_SOURCE_DIFFERENCE };
static const uint8_t too_many[20] = { TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS,
                                      TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS, TPG_SOURCE_SERVOS,
                                      TPG_SOURCE_SERVOS };
static const uint8_t unknown[1] = { 200 };
static const tpg_move_t moves[2] = { { { 3, 0, 0, 0 } }, { { -3, 0, 0, 0 } } };
static const tpg_policy_t policy = { turn_base, sources, 1U, moves, 2U };

/* The arm of tpg_arm_init_widowx. */
static const tpg_arm_description_t widowx = {
    { { 2048, 2048, 2048, 2048 } }, { 512, 256 }, { 2, 1025, 1025, 1025 }, { 4094, 3071, 3071, 3071 },
    125.0F, 142.0F, 49.0F, 142.0F, 155.0F, 160.0F, { 24.0F, -32.0F }, 10.0F, { 18.0F, -18.0F },
    { { { 68.0F, 90.0F }, { 9.0F, 9.0F } }, { { 68.0F, 68.0F }, { 9.0F, 95.0F } },
      { { 15.0F, 68.0F }, { 95.0F, 95.0F } }, { { 15.0F, 15.0F }, { 95.0F, 151.0F } } },
    0.0F,
};

static void arm_and_observation(void)
{
    static tpg_arm_t arm;
    static tpg_arm_t own;
    static tpg_arm_t raw;
    tpg_pose_t pose;
    tpg_pose_t after;
    tpg_observation_t seen;
    const tpg_move_t up = { { 3, 0, 0, 0 } };
    const float target[3] = { 0.0F, 371.0F, 257.0F };
    float hand[3];
    float state[3];
    float distance;
    int32_t code;
    tpg_arm_description_t bad = widowx;

    CHECK(tpg_version() == TPG_VERSION);
    CHECK(tpg_arm_init_widowx(NULL) == TPG_NULL);
    CHECK(tpg_arm_init_widowx(MISALIGNED(tpg_arm_t)) == TPG_MISALIGNED);
    CHECK(tpg_arm_home(&raw, &pose) == TPG_STATE);
    CHECK(tpg_arm_init_widowx(&arm) == TPG_OK);
    CHECK(tpg_arm_init(&own, &widowx) == TPG_OK);
    CHECK(memcmp(&arm, &own, sizeof arm) == 0);
    bad.min[2] = 4000;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    bad = widowx;
    bad.home.ticks[3] = 1024;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    bad = widowx;
    bad.max[0] = 4096;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    bad = widowx;
    bad.forearm = NAN;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    bad.forearm = 0.0F;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    bad = widowx;
    bad.base_edges[1].z[0] = INFINITY;
    CHECK(tpg_arm_init(&own, &bad) == TPG_ARGUMENT);
    CHECK(tpg_arm_init(&own, NULL) == TPG_NULL);
    CHECK(tpg_arm_home(&arm, &pose) == TPG_OK);
    CHECK(pose.ticks[0] == 2048);
    CHECK(tpg_arm_home(&arm, NULL) == TPG_NULL);
    CHECK(tpg_arm_home(&arm, MISALIGNED(tpg_pose_t)) == TPG_MISALIGNED);

    CHECK(tpg_arm_hand(&arm, &pose, hand) == TPG_OK);
    CHECK((fabsf(hand[0]) < 0.01F) && (fabsf(hand[1] - 346.0F) < 0.01F) && (fabsf(hand[2] - 267.0F) < 0.01F));
    CHECK(tpg_arm_hand(&arm, &pose, NULL) == TPG_NULL);
    CHECK(tpg_arm_hand(&arm, &pose, MISALIGNED(float)) == TPG_MISALIGNED);
    CHECK(tpg_arm_hand(NULL, &pose, hand) == TPG_NULL);
    CHECK(tpg_arm_collision(&arm, &pose, &code) == TPG_OK);
    CHECK(code == TPG_VALID);
    CHECK(tpg_arm_collision(&arm, &pose, NULL) == TPG_NULL);
    CHECK(tpg_arm_step(&arm, &pose, &up, &after, &code) == TPG_OK);
    CHECK((code == TPG_VALID) && (after.ticks[0] == 2051));
    pose.ticks[0] = 4094;
    CHECK(tpg_arm_step(&arm, &pose, &up, &pose, &code) == TPG_OK);
    CHECK((code == TPG_LIMIT_BASE) && (pose.ticks[0] == 4094));
    CHECK(tpg_arm_step(&arm, &pose, NULL, &after, &code) == TPG_NULL);
    CHECK(tpg_arm_step(&arm, &pose, &up, NULL, &code) == TPG_NULL);
    CHECK(tpg_arm_step(&arm, &pose, &up, &after, MISALIGNED(int32_t)) == TPG_MISALIGNED);

    pose.ticks[0] = 2048;
    CHECK(tpg_observe(&arm, &pose, target, &seen) == TPG_OK);
    CHECK((fabsf(seen.difference[1] - 25.0F) < 0.01F) && (seen.fixed_servos[1] == 256));
    CHECK(tpg_observe(&arm, &pose, NULL, &seen) == TPG_NULL);
    CHECK(tpg_observe(&arm, &pose, target, MISALIGNED(tpg_observation_t)) == TPG_MISALIGNED);
    CHECK(tpg_observation_distance(&seen, &distance) == TPG_OK);
    CHECK(fabsf(distance - sqrtf(725.0F)) < 0.01F);
    CHECK(tpg_observation_distance(NULL, &distance) == TPG_NULL);
    CHECK(tpg_observation_state(&arm, &seen, NULL, sources, 1U, state, 3U) == TPG_OK);
    CHECK(state[1] == seen.difference[1]);
    CHECK(tpg_observation_state(&arm, &seen, NULL, sources, 1U, state, 2U) == TPG_LENGTH);
    CHECK(tpg_observation_state(&arm, &seen, NULL, unknown, 1U, state, 3U) == TPG_ARGUMENT);
    CHECK(tpg_observation_state(&arm, &seen, NULL, sources, SIZE_MAX, state, 3U) == TPG_LENGTH);
    CHECK(tpg_observation_state(&arm, &seen, NULL, NULL, 1U, state, 3U) == TPG_NULL);
}

/* A memo changes nothing but the time it takes. */
static void memos(void)
{
    static tpg_arm_t arm;
    static tpg_arm_t shorter;
    static tpg_memo_t memo;
    static const uint8_t stance[] = { TPG_SOURCE_STANCE };
    static const float targets[2][3] = { { -250.0F, 239.0F, 267.0F }, { 195.0F, 350.0F, 284.0F } };
    tpg_arm_description_t description = widowx;
    tpg_pose_t pose;
    tpg_observation_t seen;
    tpg_move_t wanted;
    float kept[4];
    float anew[4];

    description.forearm = 120.0F;
    CHECK(tpg_arm_init_widowx(&arm) == TPG_OK);
    CHECK(tpg_arm_init(&shorter, &description) == TPG_OK);
    CHECK(tpg_arm_home(&arm, &pose) == TPG_OK);
    CHECK(tpg_observe(&arm, &pose, targets[0], &seen) == TPG_OK);
    CHECK(tpg_memo_init(NULL) == TPG_NULL);
    CHECK(tpg_memo_init(MISALIGNED(tpg_memo_t)) == TPG_MISALIGNED);
    CHECK(tpg_observation_state(&arm, &seen, &memo, stance, 1U, kept, 4U) == TPG_STATE);
    CHECK(tpg_policy_decide(&policy, &arm, &seen, &memo, &wanted) == TPG_STATE);
    CHECK(tpg_policy_decide(&policy, &arm, &seen, MISALIGNED(tpg_memo_t), &wanted) == TPG_MISALIGNED);
    CHECK(tpg_memo_init(&memo) == TPG_OK);
    CHECK(tpg_policy_decide(&policy, &arm, &seen, &memo, &wanted) == TPG_OK);
    for (size_t round = 0U; round < 8U; round++) {
        const tpg_arm_t *which = ((round & 4U) == 0U) ? &arm : &shorter;

        CHECK(tpg_observe(which, &pose, targets[(round >> 1) & 1U], &seen) == TPG_OK);
        CHECK(tpg_observation_state(which, &seen, &memo, stance, 1U, kept, 4U) == TPG_OK);
        CHECK(tpg_observation_state(which, &seen, NULL, stance, 1U, anew, 4U) == TPG_OK);
        CHECK(memcmp(kept, anew, sizeof kept) == 0);
    }
}

static void policies(void)
{
    static tpg_arm_t arm;
    static tpg_sac_t sac;
    static tpg_sac_t raw;
    static uint32_t scratch[MODEL_SCRATCH];
    static uint32_t damaged[MODEL_WORDS];
    tpg_policy_t other = policy;
    tpg_pose_t pose;
    tpg_observation_t seen;
    tpg_observation_t garbled;
    tpg_move_t wanted;
    size_t words = 0U;
    const float target[3] = { -250.0F, 239.0F, 267.0F };

    CHECK(tpg_arm_init_widowx(&arm) == TPG_OK);
    CHECK(tpg_arm_home(&arm, &pose) == TPG_OK);
    CHECK(tpg_observe(&arm, &pose, target, &seen) == TPG_OK);
    garbled = seen;
    CHECK(tpg_policy_decide(&policy, &arm, &seen, NULL, &wanted) == TPG_OK);
    CHECK(wanted.ticks[0] == 3);
    CHECK(tpg_policy_decide(NULL, &arm, &seen, NULL, &wanted) == TPG_NULL);
    CHECK(tpg_policy_decide(&policy, &arm, &seen, NULL, NULL) == TPG_NULL);
    other.infer = NULL;
    CHECK(tpg_policy_decide(&other, &arm, &seen, NULL, &wanted) == TPG_NULL);
    other.infer = never_moves;
    CHECK(tpg_policy_decide(&other, &arm, &seen, NULL, &wanted) == TPG_OK);
    CHECK((wanted.ticks[0] == 0) && (wanted.ticks[3] == 0));
    other.sources = unknown;
    CHECK(tpg_policy_decide(&other, &arm, &seen, NULL, &wanted) == TPG_ARGUMENT);
    other.sources = too_many;
    other.source_count = 9U;
    CHECK(tpg_policy_decide(&other, &arm, &seen, NULL, &wanted) == TPG_LENGTH);
    other = policy;
    other.moves = NULL;
    CHECK(tpg_policy_decide(&other, &arm, &seen, NULL, &wanted) == TPG_NULL);
    wanted.ticks[0] = 3;
    garbled.target[2] = NAN;
    CHECK(tpg_policy_decide(&policy, &arm, &garbled, NULL, &wanted) == TPG_BAD_TARGET);
    CHECK(wanted.ticks[0] == 0);
    garbled = seen;
    garbled.hand[0] += 1.0F;
    wanted.ticks[0] = 3;
    CHECK(tpg_policy_decide(&policy, &arm, &garbled, NULL, &wanted) == TPG_BAD_SENSOR);
    CHECK(wanted.ticks[0] == 0);

    CHECK(tpg_sac_init(&sac, model, MODEL_WORDS) == TPG_OK);
    CHECK(tpg_sac_init(NULL, model, MODEL_WORDS) == TPG_NULL);
    CHECK(tpg_sac_init(&sac, NULL, MODEL_WORDS) == TPG_NULL);
    CHECK(tpg_sac_init(&sac, MISALIGNED(uint32_t), 10U) == TPG_MISALIGNED);
    CHECK(tpg_sac_init(&sac, model, MODEL_WORDS - 1U) == TPG_LENGTH);
    CHECK(tpg_sac_init(&sac, model + 1, MODEL_WORDS - 1U) == TPG_MODEL);
    (void)memcpy(damaged, model, sizeof damaged);
    damaged[MODEL_WORDS / 2U] ^= 0x100U;
    CHECK(tpg_sac_init(&sac, damaged, MODEL_WORDS) == TPG_MODEL_CHECKSUM);
    damaged[1] -= 1U;
    CHECK(tpg_sac_init(&sac, damaged, MODEL_WORDS) == TPG_MODEL_VERSION);
    CHECK(tpg_sac_scratch(&raw, &words) == TPG_STATE);
    CHECK(tpg_sac_scratch(&sac, &words) == TPG_OK);
    CHECK(words == MODEL_SCRATCH);
    CHECK(tpg_sac_decide(&sac, &arm, &seen, scratch, MODEL_SCRATCH, &wanted) == TPG_OK);
    CHECK((wanted.ticks[0] != 0) || (wanted.ticks[1] != 0) || (wanted.ticks[2] != 0) || (wanted.ticks[3] != 0));
    CHECK(tpg_sac_decide(&sac, &arm, &seen, scratch, MODEL_SCRATCH - 1U, &wanted) == TPG_LENGTH);
    CHECK(tpg_sac_decide(&sac, &arm, &seen, NULL, MODEL_SCRATCH, &wanted) == TPG_NULL);
    CHECK(tpg_sac_decide(&raw, &arm, &seen, scratch, MODEL_SCRATCH, &wanted) == TPG_STATE);
    CHECK(tpg_sac_decide(&sac, &arm, &garbled, scratch, MODEL_SCRATCH, &wanted) == TPG_BAD_SENSOR);
    CHECK((wanted.ticks[0] == 0) && (wanted.ticks[1] == 0) && (wanted.ticks[2] == 0) && (wanted.ticks[3] == 0));
}

static void hybrids(void)
{
    static tpg_arm_t arm;
    static tpg_sac_t sac;
    static tpg_hybrid_t hybrid;
    static tpg_switch_t turn;
    static tpg_hybrid_t raw;
    static uint32_t scratch[MODEL_SCRATCH];
    tpg_settings_t settings = { 5U, 20.0F, TPG_GUARD_JOINT_LIMITS };
    tpg_policy_t idle = policy;
    tpg_observation_t seen;
    tpg_chosen_t chosen;
    tpg_counts_t counts;
    int32_t validity = TPG_VALID;
    float distance = 1000.0F;
    const tpg_watch_t no_patience = { TPG_WATCH_THRESHOLD, 0U };
    const tpg_watch_t too_great = { TPG_WATCH_NEVER + 1U, TPG_WATCH_PATIENCE };
    tpg_pose_t motors = { { 2048, 2048, 2048, 2048 } };
    const float target[3] = { 120.0F, 300.0F, 200.0F };

    idle.infer = never_moves;
    CHECK(tpg_arm_init_widowx(&arm) == TPG_OK);
    CHECK(tpg_sac_init(&sac, model, MODEL_WORDS) == TPG_OK);
    CHECK(tpg_hybrid_init(&hybrid, &arm, &idle, &sac, &settings, scratch, MODEL_SCRATCH - 1U) == TPG_LENGTH);
    CHECK(tpg_hybrid_init(&hybrid, &arm, &idle, &sac, &settings, NULL, MODEL_SCRATCH) == TPG_NULL);
    settings.guard = 7;
    CHECK(tpg_hybrid_init(&hybrid, &arm, &idle, &sac, &settings, scratch, MODEL_SCRATCH) == TPG_ARGUMENT);
    settings.guard = TPG_GUARD_JOINT_LIMITS;
    settings.hand_back_after = 0U;
    CHECK(tpg_hybrid_init(&hybrid, &arm, &idle, &sac, &settings, scratch, MODEL_SCRATCH) == TPG_ARGUMENT);
    settings.hand_back_after = 5U;
    CHECK(tpg_hybrid_init(&hybrid, &arm, &idle, &sac, &settings, scratch, MODEL_SCRATCH) == TPG_OK);

    CHECK(tpg_observe(&arm, &motors, target, &seen) == TPG_OK);
    CHECK(tpg_switch_init(&turn, &raw, NULL, &seen) == TPG_STATE);
    CHECK(tpg_switch_init(&turn, &hybrid, NULL, NULL) == TPG_NULL);
    CHECK(tpg_switch_init(&turn, &hybrid, MISALIGNED(tpg_watch_t), &seen) == TPG_MISALIGNED);
    CHECK(tpg_switch_init(&turn, &hybrid, &no_patience, &seen) == TPG_ARGUMENT);
    CHECK(tpg_switch_init(&turn, &hybrid, &too_great, &seen) == TPG_ARGUMENT);
    CHECK(tpg_switch_init(&turn, &hybrid, NULL, &seen) == TPG_OK);

    /* The graph does not move, so the network takes over, and hands back after five actions. */
    for (uint32_t step = 0U; (step < 1707U) && (distance >= 3.0F); step++) {
        CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, target, &seen, &chosen) == TPG_OK);
        CHECK(chosen.driver == (((step % 6U) == 0U) ? TPG_DRIVER_GRAPH : TPG_DRIVER_NETWORK));
        CHECK(tpg_arm_step(&arm, &motors, &chosen.wanted, &motors, &validity) == TPG_OK);
        CHECK((validity == TPG_VALID) && (tpg_observation_distance(&seen, &distance) == TPG_OK));
    }
    CHECK(distance < 3.0F);
    CHECK(tpg_switch_counts(&turn, &counts) == TPG_OK);
    CHECK((counts.network_actions > counts.graph_actions) && (counts.hand_backs > 0U));
    CHECK((counts.hand_overs[2] == counts.graph_actions) && (counts.hand_overs[0] == 0U));
    CHECK(tpg_switch_counts(&turn, NULL) == TPG_NULL);
}

/* The control step of a real arm, and the watchdog of a loop without a hybrid. */
static void steps(void)
{
    static tpg_arm_t arm;
    static tpg_sac_t sac;
    static tpg_hybrid_t hybrid;
    static tpg_switch_t turn;
    static tpg_switch_t raw;
    static tpg_watchdog_t watchdog;
    static uint32_t scratch[MODEL_SCRATCH];
    const tpg_settings_t settings = { 5U, 20.0F, TPG_GUARD_BOTH };
    const tpg_watch_t watch = { 4U, 8U };
    const float target[3] = { -250.0F, 239.0F, 267.0F };
    const float far_away[3] = { 0.0F, 460.0F, 125.0F };
    tpg_pose_t motors;
    tpg_pose_t nowhere = { { 2048, 2048, 0, 2048 } };
    tpg_observation_t seen;
    tpg_chosen_t chosen;
    tpg_counts_t counts;
    tpg_counts_t after;
    int32_t code = TPG_OK;
    uint32_t done = 0U;

    CHECK(tpg_arm_init_widowx(&arm) == TPG_OK);
    CHECK(tpg_sac_init(&sac, model, MODEL_WORDS) == TPG_OK);
    CHECK(tpg_hybrid_init(&hybrid, &arm, &policy, &sac, &settings, scratch, MODEL_SCRATCH) == TPG_OK);
    CHECK(tpg_observe(&arm, &nowhere, target, &seen) == TPG_OK);
    CHECK(tpg_switch_init(&turn, &hybrid, &watch, &seen) == TPG_BAD_SENSOR);
    CHECK(tpg_arm_home(&arm, &motors) == TPG_OK);
    CHECK(tpg_observe(&arm, &motors, target, &seen) == TPG_OK);
    CHECK(tpg_switch_init(&turn, &hybrid, &watch, &seen) == TPG_OK);
    CHECK(tpg_hybrid_step(&hybrid, &raw, &motors, target, &seen, &chosen) == TPG_STATE);
    CHECK(tpg_hybrid_step(&hybrid, &turn, NULL, target, &seen, &chosen) == TPG_NULL);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, NULL, &seen, &chosen) == TPG_NULL);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, target, NULL, &chosen) == TPG_NULL);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, target, &seen, NULL) == TPG_NULL);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, MISALIGNED(float), &seen, &chosen) == TPG_MISALIGNED);
    CHECK(tpg_switch_resume(&raw, &motors) == TPG_STATE);
    CHECK(tpg_switch_resume(&turn, NULL) == TPG_NULL);
    CHECK(tpg_switch_resume(&turn, &nowhere) == TPG_BAD_SENSOR);

    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, target, &seen, &chosen) == TPG_OK);
    CHECK(chosen.wanted.ticks[0] == 3);
    CHECK(tpg_switch_counts(&turn, &counts) == TPG_OK);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, far_away, &seen, &chosen) == TPG_BAD_TARGET);
    CHECK((chosen.wanted.ticks[0] == 0) && (seen.target[0] == target[0]));
    chosen.wanted.ticks[1] = 3;
    CHECK(tpg_hybrid_step(&hybrid, &turn, &nowhere, target, &seen, &chosen) == TPG_BAD_SENSOR);
    CHECK(chosen.wanted.ticks[1] == 0);
    CHECK(tpg_switch_counts(&turn, &after) == TPG_OK);
    CHECK(memcmp(&counts, &after, sizeof counts) == 0);

    /* Motors that do not move. */
    while ((code == TPG_OK) && (done < 100U)) {
        code = tpg_hybrid_step(&hybrid, &turn, &motors, target, &seen, &chosen);
        done++;
    }
    CHECK((code == TPG_STUCK) && (done < 8U));
    CHECK((chosen.wanted.ticks[0] == 0) && (chosen.driver == TPG_DRIVER_GRAPH));
    CHECK(tpg_switch_resume(&turn, &motors) == TPG_OK);
    CHECK(tpg_hybrid_step(&hybrid, &turn, &motors, target, &seen, &chosen) == TPG_OK);

    CHECK(tpg_watchdog_check(&watchdog, &motors, target) == TPG_STATE);
    CHECK(tpg_watchdog_init(&watchdog, &arm, NULL, &nowhere) == TPG_BAD_SENSOR);
    CHECK(tpg_watchdog_init(&watchdog, NULL, NULL, &motors) == TPG_NULL);
    CHECK(tpg_watchdog_init(&watchdog, &arm, &watch, &motors) == TPG_OK);
    CHECK(tpg_watchdog_check(&watchdog, &motors, far_away) == TPG_BAD_TARGET);
    CHECK(tpg_watchdog_check(&watchdog, &nowhere, target) == TPG_BAD_SENSOR);
    CHECK(tpg_watchdog_check(&watchdog, NULL, target) == TPG_NULL);
    CHECK(tpg_watchdog_commanded(&watchdog, &motors, NULL) == TPG_NULL);
    for (done = 0U; done < 2U; done++) {
        CHECK(tpg_watchdog_check(&watchdog, &motors, target) == TPG_OK);
        CHECK(tpg_watchdog_commanded(&watchdog, &motors, &moves[0]) == TPG_OK);
    }
    CHECK(tpg_watchdog_check(&watchdog, &motors, target) == TPG_STUCK);
    CHECK(tpg_watchdog_resume(&watchdog, &nowhere) == TPG_BAD_SENSOR);
    CHECK(tpg_watchdog_resume(&watchdog, &motors) == TPG_OK);
    CHECK(tpg_watchdog_check(&watchdog, &motors, target) == TPG_OK);
}

int main(void)
{
    arm_and_observation();
    memos();
    policies();
    hybrids();
    steps();
    return (failures == 0) ? 0 : 1;
}
