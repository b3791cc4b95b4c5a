/* The scenes of balls.c, which is made from the committed ones. */
#ifndef SCENES_H
#define SCENES_H

#include "tpg_runtime.h"

#define SCENES 100U

typedef struct scene {
    tpg_pose_t start;
    tpg_pose_t goals[TPG_GOALS];
    uint32_t goal_count;
    float radii[TPG_BALLS];
    uint32_t balls;
    /* Of the first ball before the first step, in centres. */
    uint32_t first;
    uint32_t steps;
} scene_t;

extern const float centres[][3];
extern const scene_t scenes[SCENES];

#endif
