/* Random calls of tpg_runtime.h in any order: NULL and misaligned pointers, buffers too short, NaN and infinities, any motor
 * positions, damaged models, structures that were not initialised. Everything lies in blocks of the heap of exactly its size,
 * so that a sanitizer sees the first byte beyond. Run with a seed and a number of rounds.
 *
 * Checked here: every code is one of the header's; no move is longer than its policy's; a decision that is refused moves
 * nothing. */
#include "tpg_runtime.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "numbers.h"
#include "widowx_sac.h"

static unsigned long calls;
static unsigned long wrong;
static unsigned long codes[TPG_STUCK + 1];

static uint32_t below(uint32_t bound)
{
    return (uint32_t)(number() % bound);
}

static float any_float(void)
{
    static const float odd[6] = { NAN, INFINITY, -INFINITY, 0.0F, 3.4e38F, -3.4e38F };
    const uint32_t pick = below(9U);
    const uint32_t bits = (uint32_t)number();
    float value = (float)below(1200U) - 600.0F;

    if (pick < 6U) {
        value = odd[pick];
    } else if (pick == 6U) {
        (void)memcpy(&value, &bits, sizeof value);
    }
    return value;
}

static int16_t any_ticks(void)
{
    static const int16_t odd[4] = { INT16_MAX, INT16_MIN, 4095, 0 };
    const uint32_t pick = below(9U);

    return (pick < 4U) ? odd[pick] : ((pick == 4U) ? (int16_t)(uint16_t)number() : (int16_t)(1024 + (int32_t)below(2048U)));
}

/* Notes a call and its code. */
static int32_t did(int32_t code)
{
    calls++;
    if ((code < TPG_OK) || (code > TPG_STUCK)) {
        (void)printf("code %d after %lu calls\n", (int)code, calls);
        wrong++;
    } else {
        codes[code]++;
    }
    return code;
}

static void check(bool good, const char *what)
{
    if (!good) {
        (void)printf("%s after %lu calls\n", what, calls);
        wrong++;
    }
}

/* Mostly the pointer, else NULL. */
static void *or_null(void *pointer)
{
    return (below(24U) == 0U) ? NULL : pointer;
}

/* Also misaligned, for all types but bytes. */
static void *any(void *pointer)
{
    const uint32_t pick = below(24U);

    return (pick == 0U) ? NULL : ((pick == 1U) ? (void *)((unsigned char *)pointer + 1) : pointer);
}

static void *block(size_t bytes)
{
    void *made = calloc(1U, bytes);

    if (made == NULL) {
        exit(2);
    }
    return made;
}

#define BLOCK(type) ((type *)block(sizeof(type)))

static bool still(const tpg_move_t *wanted)
{
    bool all = true;

    for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
        all = all && (wanted->ticks[joint] == 0);
    }
    return all;
}

static bool refused(int32_t code)
{
    return (code == TPG_BAD_TARGET) || (code == TPG_BAD_SENSOR) || (code == TPG_STUCK);
}

static uint32_t mode;

static uint16_t infer(const void *values)
{
    const float *first = (const float *)values;
    const uint16_t answers[4] = { (uint16_t)((first[0] > 0.0F) ? 1 : 0), 65535U, (uint16_t)number(), 3U };

    return answers[mode % 4U];
}

int main(int count, char **arguments)
{
    tpg_arm_t *arm = BLOCK(tpg_arm_t);
    tpg_arm_t *other = BLOCK(tpg_arm_t);
    tpg_arm_description_t *description = BLOCK(tpg_arm_description_t);
    tpg_hybrid_t *hybrid = BLOCK(tpg_hybrid_t);
    tpg_switch_t *turn = BLOCK(tpg_switch_t);
    tpg_memo_t *memo = BLOCK(tpg_memo_t);
    tpg_watchdog_t *watchdog = BLOCK(tpg_watchdog_t);
    tpg_sac_t *sac = BLOCK(tpg_sac_t);
    tpg_network_t *network = BLOCK(tpg_network_t);
    tpg_observation_t *seen = BLOCK(tpg_observation_t);
    tpg_pose_t *pose = BLOCK(tpg_pose_t);
    tpg_pose_t *after = BLOCK(tpg_pose_t);
    tpg_move_t *wanted = BLOCK(tpg_move_t);
    tpg_chosen_t *chosen = BLOCK(tpg_chosen_t);
    tpg_settings_t *settings = BLOCK(tpg_settings_t);
    tpg_watch_t *watch = BLOCK(tpg_watch_t);
    tpg_counts_t *counts = BLOCK(tpg_counts_t);
    tpg_policy_t *policy = BLOCK(tpg_policy_t);
    uint32_t *words = (uint32_t *)block(sizeof widowx_sac);
    uint32_t *damaged = (uint32_t *)block(sizeof widowx_sac);
    uint32_t *scratch = (uint32_t *)block(WIDOWX_SAC_SCRATCH * sizeof(uint32_t));
    uint8_t *sources = (uint8_t *)block(64U);
    tpg_move_t *moves = (tpg_move_t *)block(9U * sizeof(tpg_move_t));
    float *target = (float *)block(3U * sizeof(float));
    float *hand = (float *)block(3U * sizeof(float));
    int32_t *answer = BLOCK(int32_t);
    uint16_t *action = BLOCK(uint16_t);
    size_t *size = BLOCK(size_t);
    const long rounds = (count > 2) ? strtol(arguments[2], NULL, 10) : 20000;

    state = (count > 1) ? strtoull(arguments[1], NULL, 10) : 1U;
    (void)memcpy(words, widowx_sac, sizeof widowx_sac);
    /* What the header asks to be initialised once and to stay as it is. */
    check((tpg_arm_init_widowx(arm) == TPG_OK) && (tpg_sac_init(sac, words, WIDOWX_SAC_WORDS) == TPG_OK)
              && (tpg_network_init(network, words, WIDOWX_SAC_WORDS) == TPG_OK),
          "no start");
    for (long round = 0; round < rounds; round++) {
        int32_t code;

        for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
            pose->ticks[joint] = any_ticks();
            wanted->ticks[joint] = (int8_t)(uint8_t)number();
        }
        for (size_t k = 0U; k < 3U; k++) {
            target[k] = (below(2U) == 0U) ? any_float() : ((float)below(400U) - 200.0F);
        }
        settings->hand_back_after = (below(3U) == 0U) ? (uint32_t)number() : (1U + below(50U));
        settings->separation = (below(2U) == 0U) ? any_float() : 10.0F;
        settings->guard = (below(8U) == 0U) ? (int32_t)(uint32_t)number() : (int32_t)below(4U);
        watch->threshold = (uint16_t)((below(4U) == 0U) ? (uint32_t)number() : below(64U));
        watch->patience = (uint16_t)((below(4U) == 0U) ? (uint32_t)number() : below(64U));
        if (below(2U) == 0U) {
            (void)did(tpg_observe(arm, pose, target, seen));
        } else {
            seen->pose = *pose;
            for (size_t k = 0U; k < 3U; k++) {
                seen->hand[k] = any_float();
                seen->target[k] = any_float();
                seen->difference[k] = any_float();
            }
        }
        mode = (uint32_t)number();
        policy->infer = (below(20U) == 0U) ? NULL : infer;
        policy->sources = (const uint8_t *)or_null(sources);
        policy->source_count = below(10U);
        policy->moves = (const tpg_move_t *)or_null(moves);
        policy->move_count = below(10U);
        /* A hybrid keeps both: they change only where it is made anew. */
        switch (below(22U)) {
        case 0U: {
            float *lengths = &description->base;

            description->home = *pose;
            for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
                description->min[joint] = any_ticks();
                description->max[joint] = any_ticks();
            }
            for (size_t k = 0U; k < ((sizeof *description - offsetof(tpg_arm_description_t, base)) / sizeof(float)); k++) {
                lengths[k] = any_float();
            }
            (void)did(tpg_arm_init((tpg_arm_t *)any(other), (const tpg_arm_description_t *)any(description)));
            if (below(4U) == 0U) {
                (void)did(tpg_arm_init_widowx((tpg_arm_t *)any(other)));
            }
            break;
        }
        case 1U:
            (void)did(tpg_arm_home((below(2U) == 0U) ? arm : other, (tpg_pose_t *)any(after)));
            break;
        case 2U:
            (void)did(tpg_arm_hand((const tpg_arm_t *)any(arm), (const tpg_pose_t *)any(pose), (float *)any(hand)));
            break;
        case 3U:
            (void)did(tpg_arm_collision(other, (const tpg_pose_t *)any(pose), (int32_t *)any(answer)));
            break;
        case 4U:
            code = did(tpg_arm_step(arm, (const tpg_pose_t *)any(pose), (const tpg_move_t *)or_null(wanted),
                                    (tpg_pose_t *)any((below(2U) == 0U) ? pose : after), (int32_t *)any(answer)));
            check((code != TPG_OK) || ((*answer >= TPG_VALID) && (*answer <= TPG_COLLISION_BASE)), "a validity");
            break;
        case 5U:
            for (size_t k = 0U; k < 64U; k++) {
                sources[k] = (uint8_t)((below(60U) == 0U) ? below(256U) : below(16U));
            }
            for (size_t k = 0U; k < 9U; k++) {
                moves[k] = *wanted;
            }
            (void)did(tpg_hybrid_init((tpg_hybrid_t *)any(hybrid), (const tpg_arm_t *)any(arm), policy,
                                      (const tpg_sac_t *)any(sac), (const tpg_settings_t *)any(settings),
                                      (uint32_t *)any(scratch), (below(5U) == 0U) ? below(WIDOWX_SAC_SCRATCH) : WIDOWX_SAC_SCRATCH));
            break;
        case 6U:
            (void)did(tpg_switch_init((tpg_switch_t *)any(turn), (const tpg_hybrid_t *)any(hybrid),
                                      (const tpg_watch_t *)or_null(watch), (const tpg_observation_t *)any(seen)));
            break;
        case 7U:
        case 8U:
        case 9U:
        case 10U:
            (void)memset(chosen, 9, sizeof *chosen);
            code = did(tpg_hybrid_step((tpg_hybrid_t *)any(hybrid), (tpg_switch_t *)any(turn), (const tpg_pose_t *)any(pose),
                                       (const float *)any(target), (tpg_observation_t *)any(seen), chosen));
            check(!refused(code) || still(&chosen->wanted), "a move with a fault");
            break;
        case 11U:
            (void)did(tpg_switch_counts((const tpg_switch_t *)any(turn), (tpg_counts_t *)any(counts)));
            (void)did(tpg_switch_resume((tpg_switch_t *)any(turn), (const tpg_pose_t *)any(pose)));
            break;
        case 12U:
            (void)did(tpg_memo_init((tpg_memo_t *)any(memo)));
            break;
        case 13U:
            (void)did(tpg_observe((const tpg_arm_t *)any(other), (const tpg_pose_t *)any(pose), (const float *)any(target),
                                  (tpg_observation_t *)any(seen)));
            (void)did(tpg_observation_distance((const tpg_observation_t *)any(seen), (float *)any(hand)));
            break;
        case 14U: {
            const size_t length = below(49U);
            float *values = (float *)block((length == 0U) ? 1U : (length * sizeof(float)));

            (void)did(tpg_observation_state((const tpg_arm_t *)any((below(2U) == 0U) ? arm : other),
                                            (const tpg_observation_t *)any(seen),
                                            (tpg_memo_t *)((below(2U) == 0U) ? NULL : any(memo)),
                                            (const uint8_t *)or_null(sources), below(64U), values, length));
            free(values);
            break;
        }
        case 15U:
            (void)memset(wanted, 9, sizeof *wanted);
            code = did(tpg_policy_decide((const tpg_policy_t *)any(policy), (const tpg_arm_t *)any(arm),
                                         (const tpg_observation_t *)any(seen),
                                         (tpg_memo_t *)((below(2U) == 0U) ? NULL : any(memo)), wanted));
            check(!refused(code) || still(wanted), "a move with a fault");
            break;
        case 16U: {
            const size_t length = (below(2U) == 0U) ? WIDOWX_SAC_WORDS : below(WIDOWX_SAC_WORDS + 1U);
            tpg_sac_t *of_damaged = BLOCK(tpg_sac_t);
            tpg_network_t *net_of_damaged = BLOCK(tpg_network_t);

            (void)memcpy(damaged, widowx_sac, sizeof widowx_sac);
            for (uint32_t k = below(4U); k > 0U; k--) {
                damaged[(below(2U) == 0U) ? below(16U) : below(WIDOWX_SAC_WORDS)] = (uint32_t)number();
            }
            (void)did(tpg_sac_init((tpg_sac_t *)any(of_damaged), (const uint32_t *)any(damaged), length));
            (void)did(tpg_sac_scratch((const tpg_sac_t *)any(of_damaged), (size_t *)any(size)));
            (void)did(tpg_network_init((tpg_network_t *)any(net_of_damaged), (const uint32_t *)any(damaged), length));
            (void)did(tpg_network_scratch(net_of_damaged, (size_t *)any(size)));
            free(of_damaged);
            free(net_of_damaged);
            break;
        }
        case 17U: {
            const size_t length = below(WIDOWX_SAC_SCRATCH + 1U);
            uint32_t *exact = (uint32_t *)block((length == 0U) ? 1U : (length * sizeof(uint32_t)));

            (void)memset(wanted, 9, sizeof *wanted);
            code = did(tpg_sac_decide((const tpg_sac_t *)any(sac), (const tpg_arm_t *)any((below(2U) == 0U) ? arm : other),
                                      (const tpg_observation_t *)any(seen), exact, length, wanted));
            check(!refused(code) || still(wanted), "a move with a fault");
            free(exact);
            break;
        }
        case 18U:
            (void)did(tpg_network_inputs((const tpg_network_t *)any(network), (size_t *)any(size)));
            (void)did(tpg_network_outputs((const tpg_network_t *)any(network), (size_t *)any(size)));
            (void)did(tpg_network_choose((const tpg_network_t *)any(network), (const float *)any(target), 3U,
                                         (uint32_t *)any(scratch), WIDOWX_SAC_SCRATCH, (uint16_t *)any(action)));
            (void)did(tpg_network_values((const tpg_network_t *)any(network), (const float *)any(target), 3U,
                                         (uint32_t *)any(scratch), WIDOWX_SAC_SCRATCH, (float *)any(hand), 3U));
            break;
        case 19U:
            (void)did(tpg_watchdog_init((tpg_watchdog_t *)any(watchdog), (const tpg_arm_t *)any(arm),
                                        (const tpg_watch_t *)or_null(watch), (const tpg_pose_t *)any(pose)));
            break;
        case 20U:
            (void)did(tpg_watchdog_check((const tpg_watchdog_t *)any(watchdog), (const tpg_pose_t *)any(pose),
                                         (const float *)any(target)));
            (void)did(tpg_watchdog_commanded((tpg_watchdog_t *)any(watchdog), (const tpg_pose_t *)any(pose),
                                             (const tpg_move_t *)or_null(wanted)));
            (void)did(tpg_watchdog_resume((tpg_watchdog_t *)any(watchdog), (const tpg_pose_t *)any(pose)));
            break;
        default: {
            /* Structures of any bytes that nobody has initialised. */
            tpg_switch_t *garbage = BLOCK(tpg_switch_t);

            for (size_t k = 0U; k < (size_t)TPG_SWITCH_WORDS; k++) {
                garbage->opaque[k] = number();
            }
            check(did(tpg_switch_counts(garbage, counts)) == TPG_STATE, "garbage was taken");
            check(did(tpg_sac_init(sac, words, SIZE_MAX)) == TPG_LENGTH, "a length beyond memory");
            free(garbage);
            break;
        }
        }
        if (did(tpg_sac_decide(sac, arm, seen, scratch, WIDOWX_SAC_SCRATCH, wanted)) == TPG_OK) {
            for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
                check((wanted->ticks[joint] >= -3) && (wanted->ticks[joint] <= 3), "a move beyond 3 ticks");
            }
        }
    }
    (void)printf("calls=%lu", calls);
    for (int32_t code = TPG_OK; code <= TPG_STUCK; code++) {
        (void)printf(" %d:%lu", (int)code, codes[code]);
    }
    (void)printf("\n");
    return (wrong == 0U) ? 0 : 1;
}
