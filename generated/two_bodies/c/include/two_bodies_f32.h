/**
 * @file
 * @brief two_bodies_f32: gsmc on SE3 x SO3, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'],
 *     'doc': 'force that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders':
 *     ['params', 'state', 'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper
 *     triangle, row by row', 'entries': [['inertia_0', 0], ['inertia_2', 2], ['inertia_4', 4],
 *     ['inertia_9', 9], ['inertia_11', 11], ['inertia_17', 17], ['inertia_24', 24], ['inertia_30',
 *     30], ['inertia_35', 35], ['inertia_39', 39], ['inertia_42', 42], ['inertia_44', 44]],
 *     'holder': 'params', 'is_scalar': False, 'member': 'inertia', 'name': 'inertia', 'shape':
 *     [45], 'size': 45, 'source': '', 'unit': 'kg m^2, kg m, kg'}, {'argument': 'lambda_', 'doc':
 *     'sliding rate', 'entries': [['rate_gain', 0]], 'holder': 'params', 'is_scalar': True,
 *     'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size': 1, 'source': '', 'unit':
 *     '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries': [['reach_gain', 0]], 'holder':
 *     'params', 'is_scalar': True, 'member': 'k_s', 'name': 'reach_gain', 'shape': [1], 'size': 1,
 *     'source': '', 'unit': '1/s'}, {'argument': 'nu', 'doc': 'body velocity', 'entries': [['nu_0',
 *     0], ['nu_1', 1], ['nu_2', 2], ['nu_3', 3], ['nu_4', 4], ['nu_5', 5], ['nu_6', 6], ['nu_7',
 *     7], ['nu_8', 8]], 'holder': 'state', 'is_scalar': False, 'member': 'nu', 'name': 'nu',
 *     'shape': [9], 'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'argument': 'nu_r', 'doc':
 *     'reference velocity, reference body frame', 'entries': [['nu_r_0', 0], ['nu_r_1', 1],
 *     ['nu_r_2', 2], ['nu_r_3', 3], ['nu_r_4', 4], ['nu_r_5', 5], ['nu_r_6', 6], ['nu_r_7', 7],
 *     ['nu_r_8', 8]], 'holder': 'reference', 'is_scalar': False, 'member': 'nu', 'name': 'nu_r',
 *     'shape': [9], 'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'argument': 'nu_r_dot', 'doc':
 *     'its rate', 'entries': [['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2],
 *     ['nu_r_dot_3', 3], ['nu_r_dot_4', 4], ['nu_r_dot_5', 5], ['nu_r_dot_6', 6], ['nu_r_dot_7',
 *     7], ['nu_r_dot_8', 8]], 'holder': 'reference', 'is_scalar': False, 'member': 'nu_dot',
 *     'name': 'nu_r_dot', 'shape': [9], 'size': 9, 'source': '', 'unit': 'rad/s^2, m/s^2'},
 *     {'argument': 'g_e', 'doc': 'error, g_r^-1 g', 'entries': [['g_e_0', 0], ['g_e_1', 1],
 *     ['g_e_2', 2], ['g_e_3', 3], ['g_e_4', 4], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7], ['g_e_8',
 *     8], ['g_e_9', 9], ['g_e_10', 10], ['g_e_11', 11], ['g_e_16', 16], ['g_e_17', 17], ['g_e_18',
 *     18], ['g_e_19', 19], ['g_e_20', 20], ['g_e_21', 21], ['g_e_22', 22], ['g_e_23', 23],
 *     ['g_e_24', 24]], 'holder': '', 'is_scalar': False, 'member': 'g_e', 'name': 'g_e', 'shape':
 *     [25], 'size': 25, 'source': 'eq. (velErr)', 'unit': '1'}], 'is_public': False, 'name':
 *     'tracking', 'operations': 625, 'outputs': [{'doc': 'control force', 'entries': ['force_0',
 *     'force_1', 'force_2', 'force_3', 'force_4', 'force_5', 'force_6', 'force_7', 'force_8'],
 *     'holder': 'command', 'is_scalar': False, 'member': 'force', 'name': 'force', 'size': 9,
 *     'source': '', 'unit': 'N m, N'}, {'doc': 'sliding variable', 'entries': ['s_0', 's_1', 's_2',
 *     's_3', 's_4', 's_5', 's_6', 's_7', 's_8'], 'holder': 'command', 'is_scalar': False, 'member':
 *     's', 'name': 's', 'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'doc': 'kinematic law',
 *     'entries': ['phi_a_0', 'phi_a_1', 'phi_a_2', 'rho_p_a_0', 'rho_p_a_1', 'rho_p_a_2', 'nu_u_6',
 *     'nu_u_7', 'nu_u_8'], 'holder': 'command', 'is_scalar': False, 'member': 'nu_u', 'name':
 *     'nu_u', 'size': 9, 'source': '', 'unit': 'rad, m'}, {'doc': 'its exact rate', 'entries':
 *     ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3', 'nu_u_dot_4', 'nu_u_dot_5',
 *     'nu_u_dot_6', 'nu_u_dot_7', 'nu_u_dot_8'], 'holder': 'command', 'is_scalar': False, 'member':
 *     'nu_u_dot', 'name': 'nu_u_dot', 'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'doc':
 *     'distance from the cut locus of the law', 'entries': ['clearance_0'], 'holder': '',
 *     'is_scalar': True, 'member': 'clearance', 'name': 'clearance', 'size': 1, 'source': '',
 *     'unit': '1'}], 'public_writes': ['command', 'clearance'], 'source': 'eq. (TckCtrl)', 'steps':
 *     [{'cases': [], 'doc': 'velocity at p', 'holder': '', 'is_scalar': False, 'lines':
 *     [['eta_arm_0_a_0', 'nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2'], ['eta_arm_0_a_1', 'nu_r_4 +
 *     g_e_3*nu_r_2 - g_e_11*nu_r_0'], ['eta_arm_0_a_2', 'nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1']],
 *     'member': '', 'name': 'eta_arm_0_a', 'names': ['eta_arm_0_a_0', 'eta_arm_0_a_1',
 *     'eta_arm_0_a_2'], 'size': 3, 'source': '', 'unit': 'm/s'}, {'cases': [], 'doc': 'reference
 *     velocity in the body frame', 'holder': '', 'is_scalar': False, 'lines': [['eta_0',
 *     'g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2'], ['eta_1', 'g_e_1*nu_r_0 + g_e_5*nu_r_1 +
 *     g_e_9*nu_r_2'], ['eta_2', 'g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1'], ['eta_3',
 *     'eta_arm_0_a_0*g_e_0 + eta_arm_0_a_1*g_e_4 + eta_arm_0_a_2*g_e_8'], ['eta_4',
 *     'eta_arm_0_a_0*g_e_1 + eta_arm_0_a_1*g_e_5 + eta_arm_0_a_2*g_e_9'], ['eta_5',
 *     'eta_arm_0_a_0*g_e_2 + eta_arm_0_a_1*g_e_6 + eta_arm_0_a_2*g_e_10'], ['eta_6', 'g_e_16*nu_r_6
 *     + g_e_19*nu_r_7 + g_e_22*nu_r_8'], ['eta_7', 'g_e_17*nu_r_6 + g_e_20*nu_r_7 +
 *     g_e_23*nu_r_8'], ['eta_8', 'g_e_18*nu_r_6 + g_e_21*nu_r_7 + g_e_24*nu_r_8']], 'member': '',
 *     'name': 'eta', 'names': ['eta_0', 'eta_1', 'eta_2', 'eta_3', 'eta_4', 'eta_5', 'eta_6',
 *     'eta_7', 'eta_8'], 'size': 9, 'source': 'eq. (velErr)', 'unit': 'rad/s, m/s'}, {'cases': [],
 *     'doc': 'velocity error', 'holder': '', 'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 -
 *     eta_0'], ['nu_e_1', 'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2'], ['nu_e_3', 'nu_3 - eta_3'],
 *     ['nu_e_4', 'nu_4 - eta_4'], ['nu_e_5', 'nu_5 - eta_5'], ['nu_e_6', 'nu_6 - eta_6'],
 *     ['nu_e_7', 'nu_7 - eta_7'], ['nu_e_8', 'nu_8 - eta_8']], 'member': '', 'name': 'nu_e',
 *     'names': ['nu_e_0', 'nu_e_1', 'nu_e_2', 'nu_e_3', 'nu_e_4', 'nu_e_5', 'nu_e_6', 'nu_e_7',
 *     'nu_e_8'], 'size': 9, 'source': 'eq. (velErr)', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc':
 *     'velocity at p', 'holder': '', 'is_scalar': False, 'lines': [['eta_dot_arm_0_a_0',
 *     'nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2'], ['eta_dot_arm_0_a_1', 'nu_r_dot_4 +
 *     g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0'], ['eta_dot_arm_0_a_2', 'nu_r_dot_5 + g_e_7*nu_r_dot_0
 *     - g_e_3*nu_r_dot_1']], 'member': '', 'name': 'eta_dot_arm_0_a', 'names':
 *     ['eta_dot_arm_0_a_0', 'eta_dot_arm_0_a_1', 'eta_dot_arm_0_a_2'], 'size': 3, 'source': '',
 *     'unit': 'm/s'}, {'cases': [], 'doc': 'exact rate of eta', 'holder': '', 'is_scalar': False,
 *     'lines': [['eta_dot_0', 'eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 +
 *     g_e_8*nu_r_dot_2 - eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 + g_e_1*nu_r_dot_0 +
 *     g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 - eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 +
 *     g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 - eta_1*nu_e_0'], ['eta_dot_3',
 *     'eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_a_0*g_e_0 + eta_dot_arm_0_a_1*g_e_4 +
 *     eta_dot_arm_0_a_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1'], ['eta_dot_4', 'eta_2*nu_e_3 +
 *     eta_5*nu_e_0 + eta_dot_arm_0_a_0*g_e_1 + eta_dot_arm_0_a_1*g_e_5 + eta_dot_arm_0_a_2*g_e_9 -
 *     eta_0*nu_e_5 - eta_3*nu_e_2'], ['eta_dot_5', 'eta_0*nu_e_4 + eta_3*nu_e_1 +
 *     eta_dot_arm_0_a_0*g_e_2 + eta_dot_arm_0_a_1*g_e_6 + eta_dot_arm_0_a_2*g_e_10 - eta_1*nu_e_3 -
 *     eta_4*nu_e_0'], ['eta_dot_6', 'eta_7*nu_e_8 + g_e_16*nu_r_dot_6 + g_e_19*nu_r_dot_7 +
 *     g_e_22*nu_r_dot_8 - eta_8*nu_e_7'], ['eta_dot_7', 'eta_8*nu_e_6 + g_e_17*nu_r_dot_6 +
 *     g_e_20*nu_r_dot_7 + g_e_23*nu_r_dot_8 - eta_6*nu_e_8'], ['eta_dot_8', 'eta_6*nu_e_7 +
 *     g_e_18*nu_r_dot_6 + g_e_21*nu_r_dot_7 + g_e_24*nu_r_dot_8 - eta_7*nu_e_6']], 'member': '',
 *     'name': 'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1', 'eta_dot_2', 'eta_dot_3', 'eta_dot_4',
 *     'eta_dot_5', 'eta_dot_6', 'eta_dot_7', 'eta_dot_8'], 'size': 9, 'source': '', 'unit':
 *     'rad/s^2, m/s^2'}, {'cases': [], 'doc': '4 p p^T, p = (v, w), by rows', 'holder': '',
 *     'is_scalar': False, 'lines': [['B_a_0', '1.0F + g_e_0 - g_e_10 - g_e_5'], ['B_a_1', 'g_e_1 +
 *     g_e_4'], ['B_a_2', 'g_e_2 + g_e_8'], ['B_a_3', 'g_e_9 - g_e_6'], ['B_a_4', '1.0F + g_e_5 -
 *     g_e_0 - g_e_10'], ['B_a_5', 'g_e_6 + g_e_9'], ['B_a_6', 'g_e_2 - g_e_8'], ['B_a_7', '1.0F +
 *     g_e_10 - g_e_0 - g_e_5'], ['B_a_8', 'g_e_4 - g_e_1'], ['B_a_9', '1.0F + g_e_0 + g_e_10 +
 *     g_e_5']], 'member': '', 'name': 'B_a', 'names': ['B_a_0', 'B_a_1', 'B_a_2', 'B_a_3', 'B_a_4',
 *     'B_a_5', 'B_a_6', 'B_a_7', 'B_a_8', 'B_a_9'], 'size': 10, 'source': 'polar factor of Markley
 *     and Bar-Itzhack', 'unit': '1'}, {'cases': [{'condition': 'B_a_9 >= 1.0F', 'lines':
 *     [['column_a_0', 'B_a_3'], ['column_a_1', 'B_a_6'], ['column_a_2', 'B_a_8'], ['column_a_3',
 *     'B_a_9']]}, {'condition': '(B_a_0 >= B_a_4) && (B_a_0 >= B_a_7)', 'lines': [['column_a_0',
 *     'B_a_0'], ['column_a_1', 'B_a_1'], ['column_a_2', 'B_a_2'], ['column_a_3', 'B_a_3']]},
 *     {'condition': 'B_a_4 >= B_a_7', 'lines': [['column_a_0', 'B_a_1'], ['column_a_1', 'B_a_4'],
 *     ['column_a_2', 'B_a_5'], ['column_a_3', 'B_a_6']]}, {'condition': '', 'lines':
 *     [['column_a_0', 'B_a_2'], ['column_a_1', 'B_a_5'], ['column_a_2', 'B_a_7'], ['column_a_3',
 *     'B_a_8']]}], 'doc': 'a column of B that cannot vanish', 'holder': '', 'is_scalar': False,
 *     'lines': [], 'member': '', 'name': 'column_a', 'names': ['column_a_0', 'column_a_1',
 *     'column_a_2', 'column_a_3'], 'size': 4, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'the
 *     column after one power step', 'holder': '', 'is_scalar': False, 'lines': [['power_a_0',
 *     'B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 + B_a_3*column_a_3'], ['power_a_1',
 *     'B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 + B_a_6*column_a_3'], ['power_a_2',
 *     'B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 + B_a_8*column_a_3'], ['power_a_3',
 *     'B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 + B_a_9*column_a_3']], 'member': '',
 *     'name': 'power_a', 'names': ['power_a_0', 'power_a_1', 'power_a_2', 'power_a_3'], 'size': 4,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar':
 *     True, 'lines': [['norm_square_a', 'power_a_0*power_a_0 + power_a_1*power_a_1 +
 *     power_a_2*power_a_2 + power_a_3*power_a_3']], 'member': '', 'name': 'norm_square_a', 'names':
 *     ['norm_square_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition':
 *     'norm_square_a < 49.0F', 'lines': [['norm_bounded_a', '49.0F']]}, {'condition': '', 'lines':
 *     [['norm_bounded_a', 'norm_square_a']]}], 'doc': 'the same: less is no element', 'holder': '',
 *     'is_scalar': True, 'lines': [], 'member': '', 'name': 'norm_bounded_a', 'names':
 *     ['norm_bounded_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'length',
 *     'holder': '', 'is_scalar': True, 'lines': [['norm_a', 'sqrtf(norm_bounded_a)']], 'member':
 *     '', 'name': 'norm_a', 'names': ['norm_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [{'condition': 'power_a_3 < 0.0F', 'lines': [['scale_a', '-1.0F/norm_a']]}, {'condition': '',
 *     'lines': [['scale_a', '1.0F/norm_a']]}], 'doc': 'to unit length, and to w >= 0: the shorter
 *     way round', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'scale_a',
 *     'names': ['scale_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'cos of
 *     half the error angle, rounded', 'holder': '', 'is_scalar': True, 'lines': [['cosine_a',
 *     'power_a_3*scale_a']], 'member': '', 'name': 'cosine_a', 'names': ['cosine_a'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [{'condition': 'cosine_a > 1.0F', 'lines': [['w_a',
 *     '1.0F']]}, {'condition': '', 'lines': [['w_a', 'cosine_a']]}], 'doc': 'cos of half the error
 *     angle', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'w_a', 'names':
 *     ['w_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'sin of half the error
 *     angle times its axis', 'holder': '', 'is_scalar': False, 'lines': [['v_a_0',
 *     'power_a_0*scale_a'], ['v_a_1', 'power_a_1*scale_a'], ['v_a_2', 'power_a_2*scale_a']],
 *     'member': '', 'name': 'v_a', 'names': ['v_a_0', 'v_a_1', 'v_a_2'], 'size': 3, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': 'half angle over its sine', 'holder': '', 'is_scalar':
 *     True, 'lines': [['k_a', 'two_bodies_f32_k(w_a)']], 'member': '', 'name': 'k_a', 'names':
 *     ['k_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': '-dk/dw', 'holder': '',
 *     'is_scalar': True, 'lines': [['h_a', 'two_bodies_f32_h(w_a)']], 'member': '', 'name': 'h_a',
 *     'names': ['h_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'rotation
 *     vector of the error', 'holder': '', 'is_scalar': False, 'lines': [['phi_a_0',
 *     '2.0F*k_a*v_a_0'], ['phi_a_1', '2.0F*k_a*v_a_1'], ['phi_a_2', '2.0F*k_a*v_a_2']], 'member':
 *     '', 'name': 'phi_a', 'names': ['phi_a_0', 'phi_a_1', 'phi_a_2'], 'size': 3, 'source': '',
 *     'unit': 'rad'}, {'cases': [], 'doc': '1/(2 k)', 'holder': '', 'is_scalar': True, 'lines':
 *     [['half_a', '0.5F/k_a']], 'member': '', 'name': 'half_a', 'names': ['half_a'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'Y p', 'holder': '', 'is_scalar': False,
 *     'lines': [['swing_p_a_0', 'g_e_11*v_a_1 - g_e_7*v_a_2'], ['swing_p_a_1', 'g_e_3*v_a_2 -
 *     g_e_11*v_a_0'], ['swing_p_a_2', 'g_e_7*v_a_0 - g_e_3*v_a_1']], 'member': '', 'name':
 *     'swing_p_a', 'names': ['swing_p_a_0', 'swing_p_a_1', 'swing_p_a_2'], 'size': 3, 'source': '',
 *     'unit': 'm'}, {'cases': [], 'doc': 'Y Y p', 'holder': '', 'is_scalar': False, 'lines':
 *     [['sway_p_a_0', 'swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2'], ['sway_p_a_1', 'swing_p_a_0*v_a_2 -
 *     swing_p_a_2*v_a_0'], ['sway_p_a_2', 'swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1']], 'member': '',
 *     'name': 'sway_p_a', 'names': ['sway_p_a_0', 'sway_p_a_1', 'sway_p_a_2'], 'size': 3, 'source':
 *     '', 'unit': 'm'}, {'cases': [], 'doc': 'p - k Y p + h Y Y p', 'holder': '', 'is_scalar':
 *     False, 'lines': [['rho_p_a_0', 'g_e_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0'], ['rho_p_a_1',
 *     'g_e_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1'], ['rho_p_a_2', 'g_e_11 + h_a*sway_p_a_2 -
 *     k_a*swing_p_a_2']], 'member': '', 'name': 'rho_p_a', 'names': ['rho_p_a_0', 'rho_p_a_1',
 *     'rho_p_a_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'rho/(2 k)',
 *     'holder': '', 'is_scalar': False, 'lines': [['y_p_a_0', 'half_a*rho_p_a_0'], ['y_p_a_1',
 *     'half_a*rho_p_a_1'], ['y_p_a_2', 'half_a*rho_p_a_2']], 'member': '', 'name': 'y_p_a',
 *     'names': ['y_p_a_0', 'y_p_a_1', 'y_p_a_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases':
 *     [], 'doc': '4 p p^T, p = (v, w), by rows', 'holder': '', 'is_scalar': False, 'lines':
 *     [['B_b_0', '1.0F + g_e_16 - g_e_20 - g_e_24'], ['B_b_1', 'g_e_17 + g_e_19'], ['B_b_2',
 *     'g_e_18 + g_e_22'], ['B_b_3', 'g_e_23 - g_e_21'], ['B_b_4', '1.0F + g_e_20 - g_e_16 -
 *     g_e_24'], ['B_b_5', 'g_e_21 + g_e_23'], ['B_b_6', 'g_e_18 - g_e_22'], ['B_b_7', '1.0F +
 *     g_e_24 - g_e_16 - g_e_20'], ['B_b_8', 'g_e_19 - g_e_17'], ['B_b_9', '1.0F + g_e_16 + g_e_20 +
 *     g_e_24']], 'member': '', 'name': 'B_b', 'names': ['B_b_0', 'B_b_1', 'B_b_2', 'B_b_3',
 *     'B_b_4', 'B_b_5', 'B_b_6', 'B_b_7', 'B_b_8', 'B_b_9'], 'size': 10, 'source': 'polar factor of
 *     Markley and Bar-Itzhack', 'unit': '1'}, {'cases': [{'condition': 'B_b_9 >= 1.0F', 'lines':
 *     [['column_b_0', 'B_b_3'], ['column_b_1', 'B_b_6'], ['column_b_2', 'B_b_8'], ['column_b_3',
 *     'B_b_9']]}, {'condition': '(B_b_0 >= B_b_4) && (B_b_0 >= B_b_7)', 'lines': [['column_b_0',
 *     'B_b_0'], ['column_b_1', 'B_b_1'], ['column_b_2', 'B_b_2'], ['column_b_3', 'B_b_3']]},
 *     {'condition': 'B_b_4 >= B_b_7', 'lines': [['column_b_0', 'B_b_1'], ['column_b_1', 'B_b_4'],
 *     ['column_b_2', 'B_b_5'], ['column_b_3', 'B_b_6']]}, {'condition': '', 'lines':
 *     [['column_b_0', 'B_b_2'], ['column_b_1', 'B_b_5'], ['column_b_2', 'B_b_7'], ['column_b_3',
 *     'B_b_8']]}], 'doc': 'a column of B that cannot vanish', 'holder': '', 'is_scalar': False,
 *     'lines': [], 'member': '', 'name': 'column_b', 'names': ['column_b_0', 'column_b_1',
 *     'column_b_2', 'column_b_3'], 'size': 4, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'the
 *     column after one power step', 'holder': '', 'is_scalar': False, 'lines': [['power_b_0',
 *     'B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 + B_b_3*column_b_3'], ['power_b_1',
 *     'B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 + B_b_6*column_b_3'], ['power_b_2',
 *     'B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 + B_b_8*column_b_3'], ['power_b_3',
 *     'B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 + B_b_9*column_b_3']], 'member': '',
 *     'name': 'power_b', 'names': ['power_b_0', 'power_b_1', 'power_b_2', 'power_b_3'], 'size': 4,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar':
 *     True, 'lines': [['norm_square_b', 'power_b_0*power_b_0 + power_b_1*power_b_1 +
 *     power_b_2*power_b_2 + power_b_3*power_b_3']], 'member': '', 'name': 'norm_square_b', 'names':
 *     ['norm_square_b'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition':
 *     'norm_square_b < 49.0F', 'lines': [['norm_bounded_b', '49.0F']]}, {'condition': '', 'lines':
 *     [['norm_bounded_b', 'norm_square_b']]}], 'doc': 'the same: less is no element', 'holder': '',
 *     'is_scalar': True, 'lines': [], 'member': '', 'name': 'norm_bounded_b', 'names':
 *     ['norm_bounded_b'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'length',
 *     'holder': '', 'is_scalar': True, 'lines': [['norm_b', 'sqrtf(norm_bounded_b)']], 'member':
 *     '', 'name': 'norm_b', 'names': ['norm_b'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [{'condition': 'power_b_3 < 0.0F', 'lines': [['scale_b', '-1.0F/norm_b']]}, {'condition': '',
 *     'lines': [['scale_b', '1.0F/norm_b']]}], 'doc': 'to unit length, and to w >= 0: the shorter
 *     way round', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'scale_b',
 *     'names': ['scale_b'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'cos of
 *     half the error angle', 'holder': '', 'is_scalar': True, 'lines': [['w_b',
 *     'power_b_3*scale_b']], 'member': '', 'name': 'w_b', 'names': ['w_b'], 'size': 1, 'source':
 *     '', 'unit': '1'}, {'cases': [], 'doc': 'sin of half the error angle times its axis',
 *     'holder': '', 'is_scalar': False, 'lines': [['v_b_0', 'power_b_0*scale_b'], ['v_b_1',
 *     'power_b_1*scale_b'], ['v_b_2', 'power_b_2*scale_b']], 'member': '', 'name': 'v_b', 'names':
 *     ['v_b_0', 'v_b_1', 'v_b_2'], 'size': 3, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
 *     'half angle over its sine', 'holder': '', 'is_scalar': True, 'lines': [['k_b',
 *     'two_bodies_f32_k(w_b)']], 'member': '', 'name': 'k_b', 'names': ['k_b'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': '1 - w^2, below zero by an ulp at most',
 *     'holder': '', 'is_scalar': True, 'lines': [['sine_square_b', '(1.0F + w_b)*(1.0F - w_b)']],
 *     'member': '', 'name': 'sine_square_b', 'names': ['sine_square_b'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': '-dk/dw, as (1 - w k)/s^2', 'holder': '', 'is_scalar':
 *     True, 'lines': [['h_b', '(1.0F - k_b*w_b)/(1.0e-8F + fabsf(sine_square_b))']], 'member': '',
 *     'name': 'h_b', 'names': ['h_b'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [{'condition': 'w_a <= w_b', 'lines': [['clearance_0', 'w_a']]}, {'condition': '', 'lines':
 *     [['clearance_0', 'w_b']]}], 'doc': 'the smaller clearance', 'holder': '', 'is_scalar': True,
 *     'lines': [], 'member': '', 'name': 'clearance_0', 'names': ['clearance_0'], 'size': 1,
 *     'source': '', 'unit': '1'}, {'cases': [], 'doc': 'kinematic law, the logarithm and the
 *     rotation vector', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_6', '2.0F*k_b*v_b_0'],
 *     ['nu_u_7', '2.0F*k_b*v_b_1'], ['nu_u_8', '2.0F*k_b*v_b_2']], 'member': '', 'name': 'nu_u',
 *     'names': ['nu_u_6', 'nu_u_7', 'nu_u_8'], 'size': 9, 'source': 'def. (KctrLaw)', 'unit': 'rad,
 *     m'}, {'cases': [], 'doc': 'Y nu_e, Y = ad of y', 'holder': '', 'is_scalar': False, 'lines':
 *     [['turn_a_0', 'nu_e_2*v_a_1 - nu_e_1*v_a_2'], ['turn_a_1', 'nu_e_0*v_a_2 - nu_e_2*v_a_0'],
 *     ['turn_a_2', 'nu_e_1*v_a_0 - nu_e_0*v_a_1'], ['turn_a_3', 'nu_e_2*y_p_a_1 + nu_e_5*v_a_1 -
 *     nu_e_1*y_p_a_2 - nu_e_4*v_a_2'], ['turn_a_4', 'nu_e_0*y_p_a_2 + nu_e_3*v_a_2 - nu_e_2*y_p_a_0
 *     - nu_e_5*v_a_0'], ['turn_a_5', 'nu_e_1*y_p_a_0 + nu_e_4*v_a_0 - nu_e_0*y_p_a_1 -
 *     nu_e_3*v_a_1']], 'member': '', 'name': 'turn_a', 'names': ['turn_a_0', 'turn_a_1',
 *     'turn_a_2', 'turn_a_3', 'turn_a_4', 'turn_a_5'], 'size': 6, 'source': '', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': 'Y Y nu_e', 'holder': '', 'is_scalar': False, 'lines':
 *     [['bend_a_0', 'turn_a_2*v_a_1 - turn_a_1*v_a_2'], ['bend_a_1', 'turn_a_0*v_a_2 -
 *     turn_a_2*v_a_0'], ['bend_a_2', 'turn_a_1*v_a_0 - turn_a_0*v_a_1'], ['bend_a_3',
 *     'turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2'], ['bend_a_4',
 *     'turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0'], ['bend_a_5',
 *     'turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1']], 'member': '',
 *     'name': 'bend_a', 'names': ['bend_a_0', 'bend_a_1', 'bend_a_2', 'bend_a_3', 'bend_a_4',
 *     'bend_a_5'], 'size': 6, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': '-dh/dw',
 *     'holder': '', 'is_scalar': True, 'lines': [['m_a', 'two_bodies_f32_m(w_a)']], 'member': '',
 *     'name': 'm_a', 'names': ['m_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc':
 *     '-2 v.q', 'holder': '', 'is_scalar': True, 'lines': [['along_p_a', '-2.0F*(v_a_0*y_p_a_0 +
 *     v_a_1*y_p_a_1 + v_a_2*y_p_a_2)']], 'member': '', 'name': 'along_p_a', 'names': ['along_p_a'],
 *     'size': 1, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': '(Y^2 + s^2) Y^2 nu_e', 'holder':
 *     '', 'is_scalar': False, 'lines': [['tail_a_3', 'along_p_a*bend_a_0'], ['tail_a_4',
 *     'along_p_a*bend_a_1'], ['tail_a_5', 'along_p_a*bend_a_2']], 'member': '', 'name': 'tail_a',
 *     'names': ['tail_a_3', 'tail_a_4', 'tail_a_5'], 'size': 6, 'source': '', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': 'h^2 - k m/2, of the double root', 'holder': '', 'is_scalar':
 *     True, 'lines': [['twofold_a', 'h_a*h_a - 0.5F*k_a*m_a']], 'member': '', 'name': 'twofold_a',
 *     'names': ['twofold_a'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'v x
 *     nu_e', 'holder': '', 'is_scalar': False, 'lines': [['turn_b_0', 'nu_e_8*v_b_1 -
 *     nu_e_7*v_b_2'], ['turn_b_1', 'nu_e_6*v_b_2 - nu_e_8*v_b_0'], ['turn_b_2', 'nu_e_7*v_b_0 -
 *     nu_e_6*v_b_1']], 'member': '', 'name': 'turn_b', 'names': ['turn_b_0', 'turn_b_1',
 *     'turn_b_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc': 'v x (v x
 *     nu_e)', 'holder': '', 'is_scalar': False, 'lines': [['bend_b_0', 'turn_b_2*v_b_1 -
 *     turn_b_1*v_b_2'], ['bend_b_1', 'turn_b_0*v_b_2 - turn_b_2*v_b_0'], ['bend_b_2',
 *     'turn_b_1*v_b_0 - turn_b_0*v_b_1']], 'member': '', 'name': 'bend_b', 'names': ['bend_b_0',
 *     'bend_b_1', 'bend_b_2'], 'size': 3, 'source': '', 'unit': 'rad/s'}, {'cases': [], 'doc':
 *     'exact rate of nu_u', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_dot_0', 'nu_e_0 +
 *     bend_a_0*h_a + k_a*turn_a_0'], ['nu_u_dot_1', 'nu_e_1 + bend_a_1*h_a + k_a*turn_a_1'],
 *     ['nu_u_dot_2', 'nu_e_2 + bend_a_2*h_a + k_a*turn_a_2'], ['nu_u_dot_3', 'nu_e_3 + bend_a_3*h_a
 *     + k_a*turn_a_3 + tail_a_3*twofold_a'], ['nu_u_dot_4', 'nu_e_4 + bend_a_4*h_a + k_a*turn_a_4 +
 *     tail_a_4*twofold_a'], ['nu_u_dot_5', 'nu_e_5 + bend_a_5*h_a + k_a*turn_a_5 +
 *     tail_a_5*twofold_a'], ['nu_u_dot_6', 'nu_e_6 + bend_b_0*h_b + k_b*turn_b_0'], ['nu_u_dot_7',
 *     'nu_e_7 + bend_b_1*h_b + k_b*turn_b_1'], ['nu_u_dot_8', 'nu_e_8 + bend_b_2*h_b +
 *     k_b*turn_b_2']], 'member': '', 'name': 'nu_u_dot', 'names': ['nu_u_dot_0', 'nu_u_dot_1',
 *     'nu_u_dot_2', 'nu_u_dot_3', 'nu_u_dot_4', 'nu_u_dot_5', 'nu_u_dot_6', 'nu_u_dot_7',
 *     'nu_u_dot_8'], 'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'lambda
 *     nu_u', 'holder': '', 'is_scalar': False, 'lines': [['drive_0', 'phi_a_0*rate_gain'],
 *     ['drive_1', 'phi_a_1*rate_gain'], ['drive_2', 'phi_a_2*rate_gain'], ['drive_3',
 *     'rate_gain*rho_p_a_0'], ['drive_4', 'rate_gain*rho_p_a_1'], ['drive_5',
 *     'rate_gain*rho_p_a_2'], ['drive_6', 'nu_u_6*rate_gain'], ['drive_7', 'nu_u_7*rate_gain'],
 *     ['drive_8', 'nu_u_8*rate_gain']], 'member': '', 'name': 'drive', 'names': ['drive_0',
 *     'drive_1', 'drive_2', 'drive_3', 'drive_4', 'drive_5', 'drive_6', 'drive_7', 'drive_8'],
 *     'size': 9, 'source': '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'sliding variable',
 *     'holder': '', 'is_scalar': False, 'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 +
 *     nu_e_1'], ['s_2', 'drive_2 + nu_e_2'], ['s_3', 'drive_3 + nu_e_3'], ['s_4', 'drive_4 +
 *     nu_e_4'], ['s_5', 'drive_5 + nu_e_5'], ['s_6', 'drive_6 + nu_e_6'], ['s_7', 'drive_7 +
 *     nu_e_7'], ['s_8', 'drive_8 + nu_e_8']], 'member': '', 'name': 's', 'names': ['s_0', 's_1',
 *     's_2', 's_3', 's_4', 's_5', 's_6', 's_7', 's_8'], 'size': 9, 'source': 'eq. (SurfaceErr)',
 *     'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'acceleration asked for', 'holder': '',
 *     'is_scalar': False, 'lines': [['wanted_0', 'eta_dot_0 - nu_u_dot_0*rate_gain -
 *     reach_gain*s_0'], ['wanted_1', 'eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1'],
 *     ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2'], ['wanted_3', 'eta_dot_3 -
 *     nu_u_dot_3*rate_gain - reach_gain*s_3'], ['wanted_4', 'eta_dot_4 - nu_u_dot_4*rate_gain -
 *     reach_gain*s_4'], ['wanted_5', 'eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5'],
 *     ['wanted_6', 'eta_dot_6 - nu_u_dot_6*rate_gain - reach_gain*s_6'], ['wanted_7', 'eta_dot_7 -
 *     nu_u_dot_7*rate_gain - reach_gain*s_7'], ['wanted_8', 'eta_dot_8 - nu_u_dot_8*rate_gain -
 *     reach_gain*s_8']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1',
 *     'wanted_2', 'wanted_3', 'wanted_4', 'wanted_5', 'wanted_6', 'wanted_7', 'wanted_8'], 'size':
 *     9, 'source': '', 'unit': 'rad/s^2, m/s^2'}, {'cases': [], 'doc': 'lambda nu_u - eta',
 *     'holder': '', 'is_scalar': False, 'lines': [['turning_0', 'drive_0 - eta_0'], ['turning_1',
 *     'drive_1 - eta_1'], ['turning_2', 'drive_2 - eta_2'], ['turning_3', 'drive_3 - eta_3'],
 *     ['turning_4', 'drive_4 - eta_4'], ['turning_5', 'drive_5 - eta_5'], ['turning_6', 'drive_6 -
 *     eta_6'], ['turning_7', 'drive_7 - eta_7'], ['turning_8', 'drive_8 - eta_8']], 'member': '',
 *     'name': 'turning', 'names': ['turning_0', 'turning_1', 'turning_2', 'turning_3', 'turning_4',
 *     'turning_5', 'turning_6', 'turning_7', 'turning_8'], 'size': 9, 'source': '', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': 'I nu', 'holder': '', 'is_scalar': False, 'lines':
 *     [['momentum_0', 'inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4'], ['momentum_1',
 *     'inertia_11*nu_3 + inertia_9*nu_1'], ['momentum_2', 'inertia_17*nu_2 + inertia_2*nu_0'],
 *     ['momentum_3', 'inertia_11*nu_1 + inertia_24*nu_3'], ['momentum_4', 'inertia_30*nu_4 +
 *     inertia_4*nu_0'], ['momentum_5', 'inertia_35*nu_5'], ['momentum_6', 'inertia_39*nu_6'],
 *     ['momentum_7', 'inertia_42*nu_7'], ['momentum_8', 'inertia_44*nu_8']], 'member': '', 'name':
 *     'momentum', 'names': ['momentum_0', 'momentum_1', 'momentum_2', 'momentum_3', 'momentum_4',
 *     'momentum_5', 'momentum_6', 'momentum_7', 'momentum_8'], 'size': 9, 'source': '', 'unit': 'N
 *     m s, N s'}, {'cases': [], 'doc': 'control force, I f_u', 'holder': '', 'is_scalar': False,
 *     'lines': [['force_0', 'inertia_0*wanted_0 + inertia_2*wanted_2 + inertia_4*wanted_4 +
 *     momentum_1*turning_2 + momentum_4*turning_5 - momentum_2*turning_1 - momentum_5*turning_4'],
 *     ['force_1', 'inertia_11*wanted_3 + inertia_9*wanted_1 + momentum_2*turning_0 +
 *     momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5'], ['force_2',
 *     'inertia_17*wanted_2 + inertia_2*wanted_0 + momentum_0*turning_1 + momentum_3*turning_4 -
 *     momentum_1*turning_0 - momentum_4*turning_3'], ['force_3', 'inertia_11*wanted_1 +
 *     inertia_24*wanted_3 + momentum_4*turning_2 - momentum_5*turning_1'], ['force_4',
 *     'inertia_30*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 - momentum_3*turning_2'],
 *     ['force_5', 'inertia_35*wanted_5 + momentum_3*turning_1 - momentum_4*turning_0'], ['force_6',
 *     'inertia_39*wanted_6 + momentum_7*turning_8 - momentum_8*turning_7'], ['force_7',
 *     'inertia_42*wanted_7 + momentum_8*turning_6 - momentum_6*turning_8'], ['force_8',
 *     'inertia_44*wanted_8 + momentum_6*turning_7 - momentum_7*turning_6']], 'member': '', 'name':
 *     'force', 'names': ['force_0', 'force_1', 'force_2', 'force_3', 'force_4', 'force_5',
 *     'force_6', 'force_7', 'force_8'], 'size': 9, 'source': 'eq. (TckCtrl)', 'unit': 'N m, N'}],
 *     'symbol': 'tracking', 'temporaries': 198, 'writes': ['command', 'clearance']}, float
 *     precision.
 *
 * Generated by derive from the vehicle file two_bodies.toml; regenerate instead of editing.
 *
 * - Use: two_bodies_f32_check_params once at start-up, then two_bodies_f32_control at every
 *   instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: matrix of 4 rows, row by row; then rotation matrix, row by row.
 * - Pointers: never null; each to a whole struct, or to as many numbers as stand in the brackets,
 *   aligned as its type; what is written may not overlap what is read.
 * - Compiler: C99 with IEEE 754 numbers, rounded to nearest. Give gcc and clang
 *   -ffp-contract=off and -fno-math-errno, as the build files of the package do. The source
 *   refuses -ffast-math, -Ofast and -ffinite-math-only: control must see NaN and infinity.
 * - Needs: sqrtf of libm; memcpy and memset, which compilers call of their own accord. No heap,
 *   no data that changes, no recursion, no pointer to a function: calls may interrupt each other.
 * - Evidence: beside the folder c, EVIDENCE.md has what was proved and measured, DEVIATIONS.md
 *   where the code departs from rules, trace.csv which lines are which equation.
 */
#ifndef TWO_BODIES_F32_H
#define TWO_BODIES_F32_H

#ifdef __cplusplus
extern "C" {
#endif

#define TWO_BODIES_F32_MAX_INPUT 1.0e6F /**< largest magnitude of a number in state or reference */
#define TWO_BODIES_F32_MAX_ENTRY 1.01F /**< of an entry of the error that the group keeps at 1 */
#define TWO_BODIES_F32_MAX_REACH 4.0e6F /**< of any other entry of the error */
#define TWO_BODIES_F32_MOST_DRIFT 0.1F /**< largest max_drift that may be asked for */
#define TWO_BODIES_F32_NEAR_CUT 0.001F /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define TWO_BODIES_F32_MAX_PARAM 1.0e9F /**< largest inertia entry, force limit, or other gain */
#define TWO_BODIES_F32_MIN_GAIN 1.0e-9F /**< least gain */
#define TWO_BODIES_F32_MAX_RATE 1.0e4F /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    TWO_BODIES_F32_OK = 0, /**< the command is good */
    TWO_BODIES_F32_SATURATED = 1, /**< a force limit was reached */
    TWO_BODIES_F32_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    TWO_BODIES_F32_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    TWO_BODIES_F32_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    TWO_BODIES_F32_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    TWO_BODIES_F32_BAD_PARAMS = 19 /**< found by check_params */
} two_bodies_f32_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    float inertia[45]; /**< inertia, upper triangle, row by row [kg m^2, kg m, kg] */
    float lambda; /**< sliding rate [1/s] */
    float k_s; /**< reaching rate [1/s] */
    float max_drift; /**< largest distance of the error from the group [1] */
} two_bodies_f32_params;

/** What is measured. */
typedef struct {
    /** configuration: matrix of 4 rows, row by row; then rotation matrix, row by row [1] */
    float g[25];
    float nu[9]; /**< body velocity [rad/s, m/s] */
} two_bodies_f32_state;

/** Where to be, and how that moves. */
typedef struct {
    /** reference configuration: matrix of 4 rows, row by row; then rotation matrix, row by row [1]
            */
    float g[25];
    float nu[9]; /**< reference velocity, reference body frame [rad/s, m/s] */
    float nu_dot[9]; /**< its rate [rad/s^2, m/s^2] */
} two_bodies_f32_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    float force[9]; /**< control force [N m, N] */
    float s[9]; /**< sliding variable [rad/s, m/s] */
    float nu_u[9]; /**< kinematic law [rad, m] */
    float nu_u_dot[9]; /**< its exact rate [rad/s, m/s] */
} two_bodies_f32_command;

/** The vehicle file's inertia and gains. */
extern const two_bodies_f32_params two_bodies_f32_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
two_bodies_f32_status two_bodies_f32_check_params(const two_bodies_f32_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
two_bodies_f32_status two_bodies_f32_control(const two_bodies_f32_params *params,
        const two_bodies_f32_state *state, const two_bodies_f32_reference *reference,
        two_bodies_f32_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 733 operations, 222 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void two_bodies_f32_tracking(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        const two_bodies_f32_reference *reference, two_bodies_f32_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 445 operations, 155 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void two_bodies_f32_reaching(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        two_bodies_f32_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 113 operations, 37 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m, N]
 * @param[out] nu_dot body acceleration [rad/s^2, m/s^2]
 */
void two_bodies_f32_plant(const two_bodies_f32_params *params, const two_bodies_f32_state *state,
        const float force[9], float nu_dot[9]);

#ifdef __cplusplus
}
#endif

#endif /* TWO_BODIES_F32_H */
