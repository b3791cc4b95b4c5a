//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix bipedal_walker --profile constant-time
//! Graph SHA-256: 073ef0a378cc8a602612e78e03be167dbc630525ff9afcc4c26a06f839168795
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 192 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::Policy;

/// A tangled program graph: a formula.
///
/// It sees, one after another:
/// - `s[0..24]`: obs, , -3.1415927410125732 to 3.1415927410125732; -5 to 5; -5 to 5; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -0 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -3.1415927410125732 to 3.1415927410125732; -5 to 5; -0 to 5; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1; -1 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action_0, , -1 to 1; 0 in place of NaN
/// - `[1]`: action_1, , -1 to 1; 0 in place of NaN
/// - `[2]`: action_2, , -1 to 1; 0 in place of NaN
/// - `[3]`: action_3, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct BipedalWalker;

impl BipedalWalker {
    /// Values of a state.
    pub const STATE: usize = 24;
    /// Outputs.
    pub const OUTPUTS: usize = 4;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 192;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for BipedalWalker {
    type State = [f32; 24];
    type Action = [f32; 4];

    fn decide(&self, s: &[f32; 24]) -> [f32; 4] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] * 0.43313652_f32;
        let v5 = s[1] * 0.006045125_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * -0.9406402_f32;
        let v10 = v6 + v9;
        let v13 = s[3] * 1.1379249_f32;
        let v14 = v10 + v13;
        let v17 = s[4] * -0.27293232_f32;
        let v18 = v14 + v17;
        let v21 = s[5] * -1.2722539_f32;
        let v22 = v18 + v21;
        let v25 = s[6] * 0.99190795_f32;
        let v26 = v22 + v25;
        let v29 = s[7] * -0.46254736_f32;
        let v30 = v26 + v29;
        let v33 = s[8] * -0.36908358_f32;
        let v34 = v30 + v33;
        let v37 = s[9] * 0.42084303_f32;
        let v38 = v34 + v37;
        let v41 = s[10] * 0.23321724_f32;
        let v42 = v38 + v41;
        let v45 = s[11] * -0.11389011_f32;
        let v46 = v42 + v45;
        let v49 = s[12] * 0.43208057_f32;
        let v50 = v46 + v49;
        let v53 = s[13] * -0.010095447_f32;
        let v54 = v50 + v53;
        let v57 = s[14] * 4.4875813_f32;
        let v58 = v54 + v57;
        let v61 = s[15] * -9.051807_f32;
        let v62 = v58 + v61;
        let v65 = s[16] * -1.3506355_f32;
        let v66 = v62 + v65;
        let v69 = s[17] * 8.500628_f32;
        let v70 = v66 + v69;
        let v73 = s[18] * -6.9748583_f32;
        let v74 = v70 + v73;
        let v77 = s[19] * -0.7869225_f32;
        let v78 = v74 + v77;
        let v81 = s[20] * 7.8863435_f32;
        let v82 = v78 + v81;
        let v85 = s[21] * -3.1613417_f32;
        let v86 = v82 + v85;
        let v89 = s[22] * 0.09573793_f32;
        let v90 = v86 + v89;
        let v93 = s[23] * -6.447783_f32;
        let v94 = v90 + v93;
        let v96 = v94 + 5.9709144_f32;
        let v98 = s[0] * -0.6784458_f32;
        let v100 = s[1] * 2.167693_f32;
        let v101 = v98 + v100;
        let v103 = s[2] * 3.1354392_f32;
        let v104 = v101 + v103;
        let v106 = s[3] * -5.378494_f32;
        let v107 = v104 + v106;
        let v109 = s[4] * -0.7907029_f32;
        let v110 = v107 + v109;
        let v112 = s[5] * 0.15056907_f32;
        let v113 = v110 + v112;
        let v115 = s[6] * -2.3365674_f32;
        let v116 = v113 + v115;
        let v118 = s[7] * -0.04153449_f32;
        let v119 = v116 + v118;
        let v121 = s[8] * 0.29449865_f32;
        let v122 = v119 + v121;
        let v124 = s[9] * 0.37659582_f32;
        let v125 = v122 + v124;
        let v127 = s[10] * 0.058632873_f32;
        let v128 = v125 + v127;
        let v130 = s[11] * 2.3247058_f32;
        let v131 = v128 + v130;
        let v133 = s[12] * 0.3777262_f32;
        let v134 = v131 + v133;
        let v136 = s[13] * -0.011592703_f32;
        let v137 = v134 + v136;
        let v139 = s[14] * 10.344545_f32;
        let v140 = v137 + v139;
        let v142 = s[15] * -7.4077225_f32;
        let v143 = v140 + v142;
        let v145 = s[16] * 2.2106109_f32;
        let v146 = v143 + v145;
        let v148 = s[17] * -9.954698_f32;
        let v149 = v146 + v148;
        let v151 = s[18] * -1.1742669_f32;
        let v152 = v149 + v151;
        let v154 = s[19] * -8.619116_f32;
        let v155 = v152 + v154;
        let v157 = s[20] * 1.6254114_f32;
        let v158 = v155 + v157;
        let v160 = s[21] * 1.084647_f32;
        let v161 = v158 + v160;
        let v163 = s[22] * -0.3101107_f32;
        let v164 = v161 + v163;
        let v166 = s[23] * 18.147518_f32;
        let v167 = v164 + v166;
        let v169 = v167 + -13.862106_f32;
        let v171 = s[0] * 2.1542137_f32;
        let v173 = s[1] * -2.1436977_f32;
        let v174 = v171 + v173;
        let v176 = s[2] * 1.353505_f32;
        let v177 = v174 + v176;
        let v179 = s[3] * -1.4395895_f32;
        let v180 = v177 + v179;
        let v182 = s[4] * 1.4794261_f32;
        let v183 = v180 + v182;
        let v185 = s[5] * 0.19376321_f32;
        let v186 = v183 + v185;
        let v188 = s[6] * 0.22323757_f32;
        let v189 = v186 + v188;
        let v191 = s[7] * 0.19982354_f32;
        let v192 = v189 + v191;
        let v194 = s[8] * 0.14311513_f32;
        let v195 = v192 + v194;
        let v197 = s[9] * -0.81286705_f32;
        let v198 = v195 + v197;
        let v200 = s[10] * -0.44202605_f32;
        let v201 = v198 + v200;
        let v203 = s[11] * 0.28939056_f32;
        let v204 = v201 + v203;
        let v206 = s[12] * 0.08988224_f32;
        let v207 = v204 + v206;
        let v209 = s[13] * -0.035194054_f32;
        let v210 = v207 + v209;
        let v212 = s[14] * -1.4962751_f32;
        let v213 = v210 + v212;
        let v215 = s[15] * -2.571821_f32;
        let v216 = v213 + v215;
        let v218 = s[16] * 7.4698043_f32;
        let v219 = v216 + v218;
        let v221 = s[17] * -4.813802_f32;
        let v222 = v219 + v221;
        let v224 = s[18] * 0.45718148_f32;
        let v225 = v222 + v224;
        let v227 = s[19] * 8.570346_f32;
        let v228 = v225 + v227;
        let v230 = s[20] * 0.043355696_f32;
        let v231 = v228 + v230;
        let v233 = s[21] * -1.7338103_f32;
        let v234 = v231 + v233;
        let v236 = s[22] * -0.52388465_f32;
        let v237 = v234 + v236;
        let v239 = s[23] * 1.151409_f32;
        let v240 = v237 + v239;
        let v242 = v240 + -2.5815685_f32;
        let v244 = s[0] * -1.0676469_f32;
        let v246 = s[1] * -1.2909809_f32;
        let v247 = v244 + v246;
        let v249 = s[2] * -0.8371953_f32;
        let v250 = v247 + v249;
        let v252 = s[3] * -2.8452365_f32;
        let v253 = v250 + v252;
        let v255 = s[4] * 0.021685855_f32;
        let v256 = v253 + v255;
        let v258 = s[5] * -0.06468743_f32;
        let v259 = v256 + v258;
        let v261 = s[6] * -0.13105504_f32;
        let v262 = v259 + v261;
        let v264 = s[7] * 0.0043608746_f32;
        let v265 = v262 + v264;
        let v267 = s[8] * -0.018771987_f32;
        let v268 = v265 + v267;
        let v270 = s[9] * 0.17987023_f32;
        let v271 = v268 + v270;
        let v273 = s[10] * -0.24441965_f32;
        let v274 = v271 + v273;
        let v276 = s[11] * -1.5290816_f32;
        let v277 = v274 + v276;
        let v279 = s[12] * -0.3734259_f32;
        let v280 = v277 + v279;
        let v282 = s[13] * -0.023268756_f32;
        let v283 = v280 + v282;
        let v285 = s[14] * 0.32405788_f32;
        let v286 = v283 + v285;
        let v288 = s[15] * 5.7792134_f32;
        let v289 = v286 + v288;
        let v291 = s[16] * -7.545338_f32;
        let v292 = v289 + v291;
        let v294 = s[17] * 1.5639713_f32;
        let v295 = v292 + v294;
        let v297 = s[18] * -4.1553626_f32;
        let v298 = v295 + v297;
        let v300 = s[19] * 4.670011_f32;
        let v301 = v298 + v300;
        let v303 = s[20] * -5.031331_f32;
        let v304 = v301 + v303;
        let v306 = s[21] * 2.1768126_f32;
        let v307 = v304 + v306;
        let v309 = s[22] * -0.6732741_f32;
        let v310 = v307 + v309;
        let v312 = s[23] * -8.497251_f32;
        let v313 = v310 + v312;
        let v315 = v313 + 9.79428_f32;
        [
            ct.clamp(v96, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v169, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v242, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v315, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
