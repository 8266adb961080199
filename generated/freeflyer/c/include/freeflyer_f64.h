/**
 * @file
 * @brief freeflyer_f64: gsmc on SE3, law {'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'doc':
 *     'force that drives (g, nu) to (g_r, nu_r)', 'has_reference': True, 'holders': ['params',
 *     'state', 'reference'], 'inputs': [{'argument': 'inertia', 'doc': 'inertia, upper triangle,
 *     row by row', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2], ['inertia_4',
 *     4], ['inertia_5', 5], ['inertia_6', 6], ['inertia_7', 7], ['inertia_8', 8], ['inertia_10',
 *     10], ['inertia_11', 11], ['inertia_12', 12], ['inertia_13', 13], ['inertia_15', 15],
 *     ['inertia_18', 18], ['inertia_20', 20]], 'holder': 'params', 'is_scalar': False, 'member':
 *     'inertia', 'name': 'inertia', 'shape': [21], 'size': 21, 'source': '', 'unit': 'kg m^2, kg m,
 *     kg'}, {'argument': 'lambda_', 'doc': 'sliding rate', 'entries': [['rate_gain', 0]], 'holder':
 *     'params', 'is_scalar': True, 'member': 'lambda', 'name': 'rate_gain', 'shape': [1], 'size':
 *     1, 'source': '', 'unit': '1/s'}, {'argument': 'k_s', 'doc': 'reaching rate', 'entries':
 *     [['reach_gain', 0]], 'holder': 'params', 'is_scalar': True, 'member': 'k_s', 'name':
 *     'reach_gain', 'shape': [1], 'size': 1, 'source': '', 'unit': '1/s'}, {'argument': 'nu',
 *     'doc': 'body velocity', 'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2], ['nu_3', 3],
 *     ['nu_4', 4], ['nu_5', 5]], 'holder': 'state', 'is_scalar': False, 'member': 'nu', 'name':
 *     'nu', 'shape': [6], 'size': 6, 'source': '', 'unit': 'rad/s, m/s'}, {'argument': 'nu_r',
 *     'doc': 'reference velocity, reference body frame', 'entries': [['nu_r_0', 0], ['nu_r_1', 1],
 *     ['nu_r_2', 2], ['nu_r_3', 3], ['nu_r_4', 4], ['nu_r_5', 5]], 'holder': 'reference',
 *     'is_scalar': False, 'member': 'nu', 'name': 'nu_r', 'shape': [6], 'size': 6, 'source': '',
 *     'unit': 'rad/s, m/s'}, {'argument': 'nu_r_dot', 'doc': 'its rate', 'entries': [['nu_r_dot_0',
 *     0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2], ['nu_r_dot_3', 3], ['nu_r_dot_4', 4],
 *     ['nu_r_dot_5', 5]], 'holder': 'reference', 'is_scalar': False, 'member': 'nu_dot', 'name':
 *     'nu_r_dot', 'shape': [6], 'size': 6, 'source': '', 'unit': 'rad/s^2, m/s^2'}, {'argument':
 *     'g_e', 'doc': 'error, g_r^-1 g', 'entries': [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2],
 *     ['g_e_3', 3], ['g_e_4', 4], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7], ['g_e_8', 8], ['g_e_9',
 *     9], ['g_e_10', 10], ['g_e_11', 11]], 'holder': '', 'is_scalar': False, 'member': 'g_e',
 *     'name': 'g_e', 'shape': [16], 'size': 16, 'source': 'eq. (velErr)', 'unit': '1'}],
 *     'is_public': False, 'name': 'tracking', 'operations': 489, 'outputs': [{'doc': 'control
 *     force', 'entries': ['force_0', 'force_1', 'force_2', 'force_3', 'force_4', 'force_5'],
 *     'holder': 'command', 'is_scalar': False, 'member': 'force', 'name': 'force', 'size': 6,
 *     'source': '', 'unit': 'N m, N'}, {'doc': 'sliding variable', 'entries': ['s_0', 's_1', 's_2',
 *     's_3', 's_4', 's_5'], 'holder': 'command', 'is_scalar': False, 'member': 's', 'name': 's',
 *     'size': 6, 'source': '', 'unit': 'rad/s, m/s'}, {'doc': 'kinematic law', 'entries': ['phi_0',
 *     'phi_1', 'phi_2', 'rho_p_0', 'rho_p_1', 'rho_p_2'], 'holder': 'command', 'is_scalar': False,
 *     'member': 'nu_u', 'name': 'nu_u', 'size': 6, 'source': '', 'unit': 'rad, m'}, {'doc': 'its
 *     exact rate', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3',
 *     'nu_u_dot_4', 'nu_u_dot_5'], 'holder': 'command', 'is_scalar': False, 'member': 'nu_u_dot',
 *     'name': 'nu_u_dot', 'size': 6, 'source': '', 'unit': 'rad/s, m/s'}, {'doc': 'distance from
 *     the cut locus of the law', 'entries': ['w'], 'holder': '', 'is_scalar': True, 'member':
 *     'clearance', 'name': 'clearance', 'size': 1, 'source': '', 'unit': '1'}], 'public_writes':
 *     ['command', 'clearance'], 'source': 'eq. (TckCtrl)', 'steps': [{'cases': [], 'doc': 'velocity
 *     at p', 'holder': '', 'is_scalar': False, 'lines': [['eta_arm_0_0', 'nu_r_3 + g_e_11*nu_r_1 -
 *     g_e_7*nu_r_2'], ['eta_arm_0_1', 'nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0'], ['eta_arm_0_2',
 *     'nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1']], 'member': '', 'name': 'eta_arm_0', 'names':
 *     ['eta_arm_0_0', 'eta_arm_0_1', 'eta_arm_0_2'], 'size': 3, 'source': '', 'unit': 'm/s'},
 *     {'cases': [], 'doc': 'reference velocity in the body frame', 'holder': '', 'is_scalar':
 *     False, 'lines': [['eta_0', 'g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2'], ['eta_1',
 *     'g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2'], ['eta_2', 'g_e_10*nu_r_2 + g_e_2*nu_r_0 +
 *     g_e_6*nu_r_1'], ['eta_3', 'eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_4 + eta_arm_0_2*g_e_8'],
 *     ['eta_4', 'eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_5 + eta_arm_0_2*g_e_9'], ['eta_5',
 *     'eta_arm_0_0*g_e_2 + eta_arm_0_1*g_e_6 + eta_arm_0_2*g_e_10']], 'member': '', 'name': 'eta',
 *     'names': ['eta_0', 'eta_1', 'eta_2', 'eta_3', 'eta_4', 'eta_5'], 'size': 6, 'source': 'eq.
 *     (velErr)', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'velocity error', 'holder': '',
 *     'is_scalar': False, 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1', 'nu_1 - eta_1'],
 *     ['nu_e_2', 'nu_2 - eta_2'], ['nu_e_3', 'nu_3 - eta_3'], ['nu_e_4', 'nu_4 - eta_4'],
 *     ['nu_e_5', 'nu_5 - eta_5']], 'member': '', 'name': 'nu_e', 'names': ['nu_e_0', 'nu_e_1',
 *     'nu_e_2', 'nu_e_3', 'nu_e_4', 'nu_e_5'], 'size': 6, 'source': 'eq. (velErr)', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': 'velocity at p', 'holder': '', 'is_scalar': False, 'lines':
 *     [['eta_dot_arm_0_0', 'nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2'],
 *     ['eta_dot_arm_0_1', 'nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0'], ['eta_dot_arm_0_2',
 *     'nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1']], 'member': '', 'name': 'eta_dot_arm_0',
 *     'names': ['eta_dot_arm_0_0', 'eta_dot_arm_0_1', 'eta_dot_arm_0_2'], 'size': 3, 'source': '',
 *     'unit': 'm/s'}, {'cases': [], 'doc': 'exact rate of eta', 'holder': '', 'is_scalar': False,
 *     'lines': [['eta_dot_0', 'eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 +
 *     g_e_8*nu_r_dot_2 - eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 + g_e_1*nu_r_dot_0 +
 *     g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 - eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 +
 *     g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 - eta_1*nu_e_0'], ['eta_dot_3',
 *     'eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_0*g_e_0 + eta_dot_arm_0_1*g_e_4 +
 *     eta_dot_arm_0_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1'], ['eta_dot_4', 'eta_2*nu_e_3 +
 *     eta_5*nu_e_0 + eta_dot_arm_0_0*g_e_1 + eta_dot_arm_0_1*g_e_5 + eta_dot_arm_0_2*g_e_9 -
 *     eta_0*nu_e_5 - eta_3*nu_e_2'], ['eta_dot_5', 'eta_0*nu_e_4 + eta_3*nu_e_1 +
 *     eta_dot_arm_0_0*g_e_2 + eta_dot_arm_0_1*g_e_6 + eta_dot_arm_0_2*g_e_10 - eta_1*nu_e_3 -
 *     eta_4*nu_e_0']], 'member': '', 'name': 'eta_dot', 'names': ['eta_dot_0', 'eta_dot_1',
 *     'eta_dot_2', 'eta_dot_3', 'eta_dot_4', 'eta_dot_5'], 'size': 6, 'source': '', 'unit':
 *     'rad/s^2, m/s^2'}, {'cases': [], 'doc': '4 p p^T, p = (v, w), by rows', 'holder': '',
 *     'is_scalar': False, 'lines': [['B_0', '1.0 + g_e_0 - g_e_10 - g_e_5'], ['B_1', 'g_e_1 +
 *     g_e_4'], ['B_2', 'g_e_2 + g_e_8'], ['B_3', 'g_e_9 - g_e_6'], ['B_4', '1.0 + g_e_5 - g_e_0 -
 *     g_e_10'], ['B_5', 'g_e_6 + g_e_9'], ['B_6', 'g_e_2 - g_e_8'], ['B_7', '1.0 + g_e_10 - g_e_0 -
 *     g_e_5'], ['B_8', 'g_e_4 - g_e_1'], ['B_9', '1.0 + g_e_0 + g_e_10 + g_e_5']], 'member': '',
 *     'name': 'B', 'names': ['B_0', 'B_1', 'B_2', 'B_3', 'B_4', 'B_5', 'B_6', 'B_7', 'B_8', 'B_9'],
 *     'size': 10, 'source': 'polar factor of Markley and Bar-Itzhack', 'unit': '1'}, {'cases':
 *     [{'condition': 'B_9 >= 1.0', 'lines': [['column_0', 'B_3'], ['column_1', 'B_6'], ['column_2',
 *     'B_8'], ['column_3', 'B_9']]}, {'condition': '(B_0 >= B_4) && (B_0 >= B_7)', 'lines':
 *     [['column_0', 'B_0'], ['column_1', 'B_1'], ['column_2', 'B_2'], ['column_3', 'B_3']]},
 *     {'condition': 'B_4 >= B_7', 'lines': [['column_0', 'B_1'], ['column_1', 'B_4'], ['column_2',
 *     'B_5'], ['column_3', 'B_6']]}, {'condition': '', 'lines': [['column_0', 'B_2'], ['column_1',
 *     'B_5'], ['column_2', 'B_7'], ['column_3', 'B_8']]}], 'doc': 'a column of B that cannot
 *     vanish', 'holder': '', 'is_scalar': False, 'lines': [], 'member': '', 'name': 'column',
 *     'names': ['column_0', 'column_1', 'column_2', 'column_3'], 'size': 4, 'source': '', 'unit':
 *     '1'}, {'cases': [], 'doc': 'the column after one power step', 'holder': '', 'is_scalar':
 *     False, 'lines': [['power_0', 'B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3'],
 *     ['power_1', 'B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3'], ['power_2',
 *     'B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3'], ['power_3', 'B_3*column_0 +
 *     B_6*column_1 + B_8*column_2 + B_9*column_3']], 'member': '', 'name': 'power', 'names':
 *     ['power_0', 'power_1', 'power_2', 'power_3'], 'size': 4, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': 'squared length', 'holder': '', 'is_scalar': True, 'lines':
 *     [['norm_square', 'power_0*power_0 + power_1*power_1 + power_2*power_2 + power_3*power_3']],
 *     'member': '', 'name': 'norm_square', 'names': ['norm_square'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [{'condition': 'norm_square < 49.0', 'lines': [['norm_bounded',
 *     '49.0']]}, {'condition': '', 'lines': [['norm_bounded', 'norm_square']]}], 'doc': 'the same:
 *     less is no element', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name':
 *     'norm_bounded', 'names': ['norm_bounded'], 'size': 1, 'source': '', 'unit': '1'}, {'cases':
 *     [], 'doc': 'length', 'holder': '', 'is_scalar': True, 'lines': [['norm',
 *     'sqrt(norm_bounded)']], 'member': '', 'name': 'norm', 'names': ['norm'], 'size': 1, 'source':
 *     '', 'unit': '1'}, {'cases': [{'condition': 'power_3 < 0.0', 'lines': [['scale',
 *     '-1.0/norm']]}, {'condition': '', 'lines': [['scale', '1.0/norm']]}], 'doc': 'to unit length,
 *     and to w >= 0: the shorter way round', 'holder': '', 'is_scalar': True, 'lines': [],
 *     'member': '', 'name': 'scale', 'names': ['scale'], 'size': 1, 'source': '', 'unit': '1'},
 *     {'cases': [], 'doc': 'cos of half the error angle, rounded', 'holder': '', 'is_scalar': True,
 *     'lines': [['cosine', 'power_3*scale']], 'member': '', 'name': 'cosine', 'names': ['cosine'],
 *     'size': 1, 'source': '', 'unit': '1'}, {'cases': [{'condition': 'cosine > 1.0', 'lines':
 *     [['w', '1.0']]}, {'condition': '', 'lines': [['w', 'cosine']]}], 'doc': 'cos of half the
 *     error angle', 'holder': '', 'is_scalar': True, 'lines': [], 'member': '', 'name': 'w',
 *     'names': ['w'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'sin of half the
 *     error angle times its axis', 'holder': '', 'is_scalar': False, 'lines': [['v_0',
 *     'power_0*scale'], ['v_1', 'power_1*scale'], ['v_2', 'power_2*scale']], 'member': '', 'name':
 *     'v', 'names': ['v_0', 'v_1', 'v_2'], 'size': 3, 'source': '', 'unit': '1'}, {'cases': [],
 *     'doc': 'half angle over its sine', 'holder': '', 'is_scalar': True, 'lines': [['k',
 *     'freeflyer_f64_k(w)']], 'member': '', 'name': 'k', 'names': ['k'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': '-dk/dw', 'holder': '', 'is_scalar': True, 'lines': [['h',
 *     'freeflyer_f64_h(w)']], 'member': '', 'name': 'h', 'names': ['h'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': 'rotation vector of the error', 'holder': '', 'is_scalar':
 *     False, 'lines': [['phi_0', '2.0*k*v_0'], ['phi_1', '2.0*k*v_1'], ['phi_2', '2.0*k*v_2']],
 *     'member': '', 'name': 'phi', 'names': ['phi_0', 'phi_1', 'phi_2'], 'size': 3, 'source': '',
 *     'unit': 'rad'}, {'cases': [], 'doc': '1/(2 k)', 'holder': '', 'is_scalar': True, 'lines':
 *     [['half', '0.5/k']], 'member': '', 'name': 'half', 'names': ['half'], 'size': 1, 'source':
 *     '', 'unit': '1'}, {'cases': [], 'doc': 'Y p', 'holder': '', 'is_scalar': False, 'lines':
 *     [['swing_p_0', 'g_e_11*v_1 - g_e_7*v_2'], ['swing_p_1', 'g_e_3*v_2 - g_e_11*v_0'],
 *     ['swing_p_2', 'g_e_7*v_0 - g_e_3*v_1']], 'member': '', 'name': 'swing_p', 'names':
 *     ['swing_p_0', 'swing_p_1', 'swing_p_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases': [],
 *     'doc': 'Y Y p', 'holder': '', 'is_scalar': False, 'lines': [['sway_p_0', 'swing_p_2*v_1 -
 *     swing_p_1*v_2'], ['sway_p_1', 'swing_p_0*v_2 - swing_p_2*v_0'], ['sway_p_2', 'swing_p_1*v_0 -
 *     swing_p_0*v_1']], 'member': '', 'name': 'sway_p', 'names': ['sway_p_0', 'sway_p_1',
 *     'sway_p_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'p - k Y p + h Y Y
 *     p', 'holder': '', 'is_scalar': False, 'lines': [['rho_p_0', 'g_e_3 + h*sway_p_0 -
 *     k*swing_p_0'], ['rho_p_1', 'g_e_7 + h*sway_p_1 - k*swing_p_1'], ['rho_p_2', 'g_e_11 +
 *     h*sway_p_2 - k*swing_p_2']], 'member': '', 'name': 'rho_p', 'names': ['rho_p_0', 'rho_p_1',
 *     'rho_p_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'rho/(2 k)',
 *     'holder': '', 'is_scalar': False, 'lines': [['y_p_0', 'half*rho_p_0'], ['y_p_1',
 *     'half*rho_p_1'], ['y_p_2', 'half*rho_p_2']], 'member': '', 'name': 'y_p', 'names': ['y_p_0',
 *     'y_p_1', 'y_p_2'], 'size': 3, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': 'Y nu_e, Y =
 *     ad of y', 'holder': '', 'is_scalar': False, 'lines': [['turn_0', 'nu_e_2*v_1 - nu_e_1*v_2'],
 *     ['turn_1', 'nu_e_0*v_2 - nu_e_2*v_0'], ['turn_2', 'nu_e_1*v_0 - nu_e_0*v_1'], ['turn_3',
 *     'nu_e_2*y_p_1 + nu_e_5*v_1 - nu_e_1*y_p_2 - nu_e_4*v_2'], ['turn_4', 'nu_e_0*y_p_2 +
 *     nu_e_3*v_2 - nu_e_2*y_p_0 - nu_e_5*v_0'], ['turn_5', 'nu_e_1*y_p_0 + nu_e_4*v_0 -
 *     nu_e_0*y_p_1 - nu_e_3*v_1']], 'member': '', 'name': 'turn', 'names': ['turn_0', 'turn_1',
 *     'turn_2', 'turn_3', 'turn_4', 'turn_5'], 'size': 6, 'source': '', 'unit': 'rad/s, m/s'},
 *     {'cases': [], 'doc': 'Y Y nu_e', 'holder': '', 'is_scalar': False, 'lines': [['bend_0',
 *     'turn_2*v_1 - turn_1*v_2'], ['bend_1', 'turn_0*v_2 - turn_2*v_0'], ['bend_2', 'turn_1*v_0 -
 *     turn_0*v_1'], ['bend_3', 'turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2'], ['bend_4',
 *     'turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0'], ['bend_5', 'turn_1*y_p_0 +
 *     turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1']], 'member': '', 'name': 'bend', 'names': ['bend_0',
 *     'bend_1', 'bend_2', 'bend_3', 'bend_4', 'bend_5'], 'size': 6, 'source': '', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': '-dh/dw', 'holder': '', 'is_scalar': True, 'lines': [['m',
 *     'freeflyer_f64_m(w)']], 'member': '', 'name': 'm', 'names': ['m'], 'size': 1, 'source': '',
 *     'unit': '1'}, {'cases': [], 'doc': '-2 v.q', 'holder': '', 'is_scalar': True, 'lines':
 *     [['along_p', '-2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2)']], 'member': '', 'name': 'along_p',
 *     'names': ['along_p'], 'size': 1, 'source': '', 'unit': 'm'}, {'cases': [], 'doc': '(Y^2 +
 *     s^2) Y^2 nu_e', 'holder': '', 'is_scalar': False, 'lines': [['tail_3', 'along_p*bend_0'],
 *     ['tail_4', 'along_p*bend_1'], ['tail_5', 'along_p*bend_2']], 'member': '', 'name': 'tail',
 *     'names': ['tail_3', 'tail_4', 'tail_5'], 'size': 6, 'source': '', 'unit': 'rad/s, m/s'},
 *     {'cases': [], 'doc': 'h^2 - k m/2, of the double root', 'holder': '', 'is_scalar': True,
 *     'lines': [['twofold', 'h*h - 0.5*k*m']], 'member': '', 'name': 'twofold', 'names':
 *     ['twofold'], 'size': 1, 'source': '', 'unit': '1'}, {'cases': [], 'doc': 'exact rate of
 *     nu_u', 'holder': '', 'is_scalar': False, 'lines': [['nu_u_dot_0', 'nu_e_0 + bend_0*h +
 *     k*turn_0'], ['nu_u_dot_1', 'nu_e_1 + bend_1*h + k*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h
 *     + k*turn_2'], ['nu_u_dot_3', 'nu_e_3 + bend_3*h + k*turn_3 + tail_3*twofold'], ['nu_u_dot_4',
 *     'nu_e_4 + bend_4*h + k*turn_4 + tail_4*twofold'], ['nu_u_dot_5', 'nu_e_5 + bend_5*h +
 *     k*turn_5 + tail_5*twofold']], 'member': '', 'name': 'nu_u_dot', 'names': ['nu_u_dot_0',
 *     'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3', 'nu_u_dot_4', 'nu_u_dot_5'], 'size': 6, 'source':
 *     '', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc': 'lambda nu_u', 'holder': '', 'is_scalar':
 *     False, 'lines': [['drive_0', 'phi_0*rate_gain'], ['drive_1', 'phi_1*rate_gain'], ['drive_2',
 *     'phi_2*rate_gain'], ['drive_3', 'rate_gain*rho_p_0'], ['drive_4', 'rate_gain*rho_p_1'],
 *     ['drive_5', 'rate_gain*rho_p_2']], 'member': '', 'name': 'drive', 'names': ['drive_0',
 *     'drive_1', 'drive_2', 'drive_3', 'drive_4', 'drive_5'], 'size': 6, 'source': '', 'unit':
 *     'rad/s, m/s'}, {'cases': [], 'doc': 'sliding variable', 'holder': '', 'is_scalar': False,
 *     'lines': [['s_0', 'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 +
 *     nu_e_2'], ['s_3', 'drive_3 + nu_e_3'], ['s_4', 'drive_4 + nu_e_4'], ['s_5', 'drive_5 +
 *     nu_e_5']], 'member': '', 'name': 's', 'names': ['s_0', 's_1', 's_2', 's_3', 's_4', 's_5'],
 *     'size': 6, 'source': 'eq. (SurfaceErr)', 'unit': 'rad/s, m/s'}, {'cases': [], 'doc':
 *     'acceleration asked for', 'holder': '', 'is_scalar': False, 'lines': [['wanted_0', 'eta_dot_0
 *     - nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 - nu_u_dot_1*rate_gain -
 *     reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2'],
 *     ['wanted_3', 'eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3'], ['wanted_4', 'eta_dot_4 -
 *     nu_u_dot_4*rate_gain - reach_gain*s_4'], ['wanted_5', 'eta_dot_5 - nu_u_dot_5*rate_gain -
 *     reach_gain*s_5']], 'member': '', 'name': 'wanted', 'names': ['wanted_0', 'wanted_1',
 *     'wanted_2', 'wanted_3', 'wanted_4', 'wanted_5'], 'size': 6, 'source': '', 'unit': 'rad/s^2,
 *     m/s^2'}, {'cases': [], 'doc': 'lambda nu_u - eta', 'holder': '', 'is_scalar': False, 'lines':
 *     [['turning_0', 'drive_0 - eta_0'], ['turning_1', 'drive_1 - eta_1'], ['turning_2', 'drive_2 -
 *     eta_2'], ['turning_3', 'drive_3 - eta_3'], ['turning_4', 'drive_4 - eta_4'], ['turning_5',
 *     'drive_5 - eta_5']], 'member': '', 'name': 'turning', 'names': ['turning_0', 'turning_1',
 *     'turning_2', 'turning_3', 'turning_4', 'turning_5'], 'size': 6, 'source': '', 'unit': 'rad/s,
 *     m/s'}, {'cases': [], 'doc': 'I nu', 'holder': '', 'is_scalar': False, 'lines':
 *     [['momentum_0', 'inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 +
 *     inertia_5*nu_5'], ['momentum_1', 'inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 +
 *     inertia_7*nu_2 + inertia_8*nu_3'], ['momentum_2', 'inertia_11*nu_2 + inertia_12*nu_3 +
 *     inertia_13*nu_4 + inertia_2*nu_0 + inertia_7*nu_1'], ['momentum_3', 'inertia_12*nu_2 +
 *     inertia_15*nu_3 + inertia_8*nu_1'], ['momentum_4', 'inertia_13*nu_2 + inertia_18*nu_4 +
 *     inertia_4*nu_0'], ['momentum_5', 'inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0']],
 *     'member': '', 'name': 'momentum', 'names': ['momentum_0', 'momentum_1', 'momentum_2',
 *     'momentum_3', 'momentum_4', 'momentum_5'], 'size': 6, 'source': '', 'unit': 'N m s, N s'},
 *     {'cases': [], 'doc': 'control force, I f_u', 'holder': '', 'is_scalar': False, 'lines':
 *     [['force_0', 'inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 +
 *     inertia_4*wanted_4 + inertia_5*wanted_5 + momentum_1*turning_2 + momentum_4*turning_5 -
 *     momentum_2*turning_1 - momentum_5*turning_4'], ['force_1', 'inertia_1*wanted_0 +
 *     inertia_10*wanted_5 + inertia_6*wanted_1 + inertia_7*wanted_2 + inertia_8*wanted_3 +
 *     momentum_2*turning_0 + momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5'],
 *     ['force_2', 'inertia_11*wanted_2 + inertia_12*wanted_3 + inertia_13*wanted_4 +
 *     inertia_2*wanted_0 + inertia_7*wanted_1 + momentum_0*turning_1 + momentum_3*turning_4 -
 *     momentum_1*turning_0 - momentum_4*turning_3'], ['force_3', 'inertia_12*wanted_2 +
 *     inertia_15*wanted_3 + inertia_8*wanted_1 + momentum_4*turning_2 - momentum_5*turning_1'],
 *     ['force_4', 'inertia_13*wanted_2 + inertia_18*wanted_4 + inertia_4*wanted_0 +
 *     momentum_5*turning_0 - momentum_3*turning_2'], ['force_5', 'inertia_10*wanted_1 +
 *     inertia_20*wanted_5 + inertia_5*wanted_0 + momentum_3*turning_1 - momentum_4*turning_0']],
 *     'member': '', 'name': 'force', 'names': ['force_0', 'force_1', 'force_2', 'force_3',
 *     'force_4', 'force_5'], 'size': 6, 'source': 'eq. (TckCtrl)', 'unit': 'N m, N'}], 'symbol':
 *     'tracking', 'temporaries': 129, 'writes': ['command', 'clearance']}, double precision.
 *
 * Generated by derive from the vehicle file freeflyer.toml; regenerate instead of editing.
 *
 * - Use: freeflyer_f64_check_params once at start-up, then freeflyer_f64_control at every instant.
 * - Units: SI; they stand in brackets beside each number.
 * - Frames: velocities and forces are in the body frame; the reference's in the reference's own.
 * - Configuration g: matrix of 4 rows, row by row.
 * - Pointers: never null; each to a whole struct, or to as many numbers as stand in the brackets,
 *   aligned as its type; what is written may not overlap what is read.
 * - Compiler: C99 with IEEE 754 numbers, rounded to nearest. Give gcc and clang
 *   -ffp-contract=off and -fno-math-errno, as the build files of the package do. The source
 *   refuses -ffast-math, -Ofast and -ffinite-math-only: control must see NaN and infinity.
 * - Needs: sqrt of libm; memcpy and memset, which compilers call of their own accord. No heap,
 *   no data that changes, no recursion, no pointer to a function: calls may interrupt each other.
 * - Evidence: beside the folder c, EVIDENCE.md has what was proved and measured, DEVIATIONS.md
 *   where the code departs from rules, trace.csv which lines are which equation.
 */
#ifndef FREEFLYER_F64_H
#define FREEFLYER_F64_H

#ifdef __cplusplus
extern "C" {
#endif

#define FREEFLYER_F64_MAX_INPUT 1.0e6 /**< largest magnitude of a number in state or reference */
#define FREEFLYER_F64_MAX_ENTRY 1.01 /**< of an entry of the error that the group keeps at 1 */
#define FREEFLYER_F64_MAX_REACH 4.0e6 /**< of any other entry of the error */
#define FREEFLYER_F64_MOST_DRIFT 0.1 /**< largest max_drift that may be asked for */
#define FREEFLYER_F64_NEAR_CUT 0.001 /**< clearance below which NEAR_CUT_LOCUS is flagged */
#define FREEFLYER_F64_MAX_PARAM 1.0e9 /**< largest inertia entry, force limit, or other gain */
#define FREEFLYER_F64_MIN_GAIN 1.0e-9 /**< least gain */
#define FREEFLYER_F64_MAX_RATE 1.0e4 /**< largest gain in 1/s */

/** What was found. The largest that applies is returned; from 16 on the whole command is zero. */
typedef enum {
    FREEFLYER_F64_OK = 0, /**< the command is good */
    FREEFLYER_F64_SATURATED = 1, /**< a force limit was reached */
    FREEFLYER_F64_NEAR_CUT_LOCUS = 2, /**< the error is close to where the law jumps */
    FREEFLYER_F64_NOT_ON_GROUP = 16, /**< the error is off the group by more than max_drift */
    FREEFLYER_F64_OUT_OF_RANGE = 17, /**< beyond MAX_INPUT, or too near a pole of the law */
    FREEFLYER_F64_NONFINITE_INPUT = 18, /**< an input, or what it leads to, is not finite */
    FREEFLYER_F64_BAD_PARAMS = 19 /**< found by check_params */
} freeflyer_f64_status;

/** Inertia and gains, from the vehicle file or tuned on the target. */
typedef struct {
    double inertia[21]; /**< inertia, upper triangle, row by row [kg m^2, kg m, kg] */
    double lambda; /**< sliding rate [1/s] */
    double k_s; /**< reaching rate [1/s] */
    double max_drift; /**< largest distance of the error from the group [1] */
} freeflyer_f64_params;

/** What is measured. */
typedef struct {
    double g[16]; /**< configuration: matrix of 4 rows, row by row [1] */
    double nu[6]; /**< body velocity [rad/s, m/s] */
} freeflyer_f64_state;

/** Where to be, and how that moves. */
typedef struct {
    double g[16]; /**< reference configuration: matrix of 4 rows, row by row [1] */
    double nu[6]; /**< reference velocity, reference body frame [rad/s, m/s] */
    double nu_dot[6]; /**< its rate [rad/s^2, m/s^2] */
} freeflyer_f64_reference;

/** What is to be done, and what it was made of. */
typedef struct {
    double force[6]; /**< control force [N m, N] */
    double s[6]; /**< sliding variable [rad/s, m/s] */
    double nu_u[6]; /**< kinematic law [rad, m] */
    double nu_u_dot[6]; /**< its exact rate [rad/s, m/s] */
} freeflyer_f64_command;

/** The vehicle file's inertia and gains. */
extern const freeflyer_f64_params freeflyer_f64_defaults;

/**
 * Judges the parameters, once at start-up.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @return OK; or BAD_PARAMS when one is not finite or out of range, the inertia not positive
 *     definite, or not zero where the derivation took that for granted
 */
freeflyer_f64_status freeflyer_f64_check_params(const freeflyer_f64_params *params);

/**
 * The guarded controller, for parameters that were checked. Whatever bits the other inputs are
 * made of, all of the command is written, and it is finite.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 * @return the largest status that applies
 */
freeflyer_f64_status freeflyer_f64_control(const freeflyer_f64_params *params,
        const freeflyer_f64_state *state, const freeflyer_f64_reference *reference,
        freeflyer_f64_command *command);

/**
 * Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).
 * Unguarded: presumes what control checks. Cost: 552 operations, 144 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] reference where to be, and how that moves
 * @param[out] command what is to be done, and what it was made of
 */
void freeflyer_f64_tracking(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        const freeflyer_f64_reference *reference, freeflyer_f64_command *command);

/**
 * Force that drives (g, nu) to (e, 0); eq. (Ctrl2).
 * Unguarded: presumes what control checks. Cost: 357 operations, 99 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[out] command what is to be done, and what it was made of
 */
void freeflyer_f64_reaching(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        freeflyer_f64_command *command);

/**
 * Acceleration under a force, Euler-Poincare; eq. (EulerP).
 * Unguarded: presumes what control checks. Cost: 244 operations, 42 temporaries.
 * @param[in] params inertia and gains, from the vehicle file or tuned on the target
 * @param[in] state what is measured
 * @param[in] force applied force [N m, N]
 * @param[out] nu_dot body acceleration [rad/s^2, m/s^2]
 */
void freeflyer_f64_plant(const freeflyer_f64_params *params, const freeflyer_f64_state *state,
        const double force[6], double nu_dot[6]);

#ifdef __cplusplus
}
#endif

#endif /* FREEFLYER_F64_H */
