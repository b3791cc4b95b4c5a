/* Tasks side by side that share what the header says may be shared: arm, policies, network, model, settings. Each has its own
 * hybrid, switch, scratch memory and episode. Run with a seed and a number of episodes; under ThreadSanitizer, which sees
 * whatever one task writes and another reads. Each task takes the same episodes, so each must end with the same sum. */
#include "tpg_runtime.h"

#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "numbers.h"
#include "widowx_rs.h"
#include "widowx_sac.h"

#define TASKS 4U
#define MAX_ACTIONS 300U
#define EPISODES 200U

typedef struct task {
    tpg_hybrid_t hybrid;
    uint32_t scratch[WIDOWX_SAC_SCRATCH];
    uint64_t sum;
    int32_t code;
} task_t;

static uint16_t infer_rs(const void *values)
{
    return widowx_rs_infer((const widowx_rs_state_t *)values);
}

static const uint8_t sources[] = WIDOWX_RS_SOURCES;
static const tpg_move_t moves[] = WIDOWX_RS_MOVES;
static const tpg_policy_t policy = { infer_rs, sources, WIDOWX_RS_SOURCE_COUNT, moves, WIDOWX_RS_ACTIONS };
static const tpg_settings_t settings = { 5U, 20.0F, TPG_GUARD_BOTH };
static tpg_arm_t arm;
static tpg_sac_t sac;
static tpg_problem_t problems[EPISODES];
static size_t episodes = EPISODES;

/* One episode; adds its actions to the task's sum. */
static int32_t play(task_t *task, const tpg_problem_t *problem)
{
    tpg_hybrid_episode_t episode;
    tpg_chosen_t chosen;
    int32_t outcome = TPG_RUNNING;
    int32_t code = tpg_hybrid_episode_init(&episode, &task->hybrid, problem);

    while ((code == TPG_OK) && (outcome == TPG_RUNNING)) {
        code = tpg_hybrid_episode_decide(&episode, &chosen);
        if (code == TPG_OK) {
            code = tpg_hybrid_episode_act(&episode, &chosen, &outcome);
        }
        for (size_t joint = 0U; joint < (size_t)TPG_JOINTS; joint++) {
            task->sum = (task->sum * 31U) + (uint64_t)(uint8_t)chosen.wanted.ticks[joint];
        }
        task->sum = (task->sum * 31U) + (uint64_t)(uint32_t)chosen.driver;
    }
    return code;
}

static void *run(void *argument)
{
    task_t *task = (task_t *)argument;

    task->code = tpg_hybrid_init(&task->hybrid, &arm, &policy, &sac, &settings, task->scratch, WIDOWX_SAC_SCRATCH);
    for (size_t index = 0U; (index < episodes) && (task->code == TPG_OK); index++) {
        task->code = play(task, &problems[index]);
    }
    return NULL;
}

int main(int count, char **arguments)
{
    static task_t tasks[TASKS];
    pthread_t threads[TASKS];

    state = (count > 1) ? strtoull(arguments[1], NULL, 10) : 1U;
    if (count > 2) {
        const unsigned long wanted = strtoul(arguments[2], NULL, 10);

        episodes = (wanted < EPISODES) ? (size_t)wanted : EPISODES;
    }
    if ((tpg_arm_init_widowx(&arm) != TPG_OK) || (tpg_sac_init(&sac, widowx_sac, WIDOWX_SAC_WORDS) != TPG_OK)) {
        return 2;
    }
    for (size_t index = 0U; index < episodes; index++) {
        tpg_problem_t *problem = &problems[index];

        if (tpg_arm_home(&arm, &problem->start) != TPG_OK) {
            return 2;
        }
        problem->target[0] = (float)(int32_t)(number() % 500U) - 250.0F;
        problem->target[1] = (float)(int32_t)(number() % 500U) - 250.0F;
        problem->target[2] = (float)(int32_t)(number() % 250U);
        problem->tolerance = 30.0F;
        problem->max_actions = MAX_ACTIONS;
    }
    for (size_t index = 0U; index < TASKS; index++) {
        if (pthread_create(&threads[index], NULL, run, &tasks[index]) != 0) {
            return 2;
        }
    }
    for (size_t index = 0U; index < TASKS; index++) {
        if (pthread_join(threads[index], NULL) != 0) {
            return 2;
        }
    }
    for (size_t index = 0U; index < TASKS; index++) {
        if ((tasks[index].code != TPG_OK) || (tasks[index].sum != tasks[0].sum) || (tasks[index].sum == 0U)) {
            (void)printf("task %u: code %d, sum %016llx, the first one's %016llx\n", (unsigned)index, (int)tasks[index].code,
                         (unsigned long long)tasks[index].sum, (unsigned long long)tasks[0].sum);
            return 1;
        }
    }
    (void)printf("%u tasks, %u episodes each, sum %016llx\n", TASKS, (unsigned)episodes, (unsigned long long)tasks[0].sum);
    return 0;
}
