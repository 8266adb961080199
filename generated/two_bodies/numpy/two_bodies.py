"""two_bodies: gsmc on SE3 x SO3, law {'name': 'tracking', 'doc': 'force that drives (g, nu) to
(g_r, nu_r)', 'source': 'eq. (TckCtrl)', 'inputs': [{'name': 'inertia', 'size': 45, 'unit': 'kg m^2,
kg m, kg', 'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar': False, 'holder':
'params', 'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_2', 2], ['inertia_4', 4],
['inertia_9', 9], ['inertia_11', 11], ['inertia_17', 17], ['inertia_24', 24], ['inertia_30', 30],
['inertia_35', 35], ['inertia_39', 39], ['inertia_42', 42], ['inertia_44', 44]], 'argument':
'inertia', 'shape': (45,)}, {'name': 'rate_gain', 'size': 1, 'unit': '1/s', 'doc': 'sliding rate',
'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'lambda', 'entries': [['rate_gain',
0]], 'argument': 'lambda_', 'shape': (1,)}, {'name': 'reach_gain', 'size': 1, 'unit': '1/s', 'doc':
'reaching rate', 'source': '', 'is_scalar': True, 'holder': 'params', 'member': 'k_s', 'entries':
[['reach_gain', 0]], 'argument': 'k_s', 'shape': (1,)}, {'name': 'nu', 'size': 9, 'unit': 'rad/s,
m/s', 'doc': 'body velocity', 'source': '', 'is_scalar': False, 'holder': 'state', 'member': 'nu',
'entries': [['nu_0', 0], ['nu_1', 1], ['nu_2', 2], ['nu_3', 3], ['nu_4', 4], ['nu_5', 5], ['nu_6',
6], ['nu_7', 7], ['nu_8', 8]], 'argument': 'nu', 'shape': (9,)}, {'name': 'nu_r', 'size': 9, 'unit':
'rad/s, m/s', 'doc': 'reference velocity, reference body frame', 'source': '', 'is_scalar': False,
'holder': 'reference', 'member': 'nu', 'entries': [['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2],
['nu_r_3', 3], ['nu_r_4', 4], ['nu_r_5', 5], ['nu_r_6', 6], ['nu_r_7', 7], ['nu_r_8', 8]],
'argument': 'nu_r', 'shape': (9,)}, {'name': 'nu_r_dot', 'size': 9, 'unit': 'rad/s^2, m/s^2', 'doc':
'its rate', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu_dot', 'entries':
[['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2], ['nu_r_dot_3', 3], ['nu_r_dot_4', 4],
['nu_r_dot_5', 5], ['nu_r_dot_6', 6], ['nu_r_dot_7', 7], ['nu_r_dot_8', 8]], 'argument': 'nu_r_dot',
'shape': (9,)}, {'name': 'g_e', 'size': 25, 'unit': '1', 'doc': 'error, g_r^-1 g', 'source': 'eq.
(velErr)', 'is_scalar': False, 'holder': '', 'member': 'g_e', 'entries': [['g_e_0', 0], ['g_e_1',
1], ['g_e_2', 2], ['g_e_3', 3], ['g_e_4', 4], ['g_e_5', 5], ['g_e_6', 6], ['g_e_7', 7], ['g_e_8',
8], ['g_e_9', 9], ['g_e_10', 10], ['g_e_11', 11], ['g_e_16', 16], ['g_e_17', 17], ['g_e_18', 18],
['g_e_19', 19], ['g_e_20', 20], ['g_e_21', 21], ['g_e_22', 22], ['g_e_23', 23], ['g_e_24', 24]],
'argument': 'g_e', 'shape': (25,)}], 'steps': [{'name': 'eta_arm_0_a', 'size': 3, 'unit': 'm/s',
'doc': 'velocity at p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['eta_arm_0_a_0', 'eta_arm_0_a_1', 'eta_arm_0_a_2'], 'lines': [['eta_arm_0_a_0', 'nu_r_3 +
g_e_11*nu_r_1 - g_e_7*nu_r_2'], ['eta_arm_0_a_1', 'nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0'],
['eta_arm_0_a_2', 'nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1']], 'cases': []}, {'name': 'eta', 'size': 9,
'unit': 'rad/s, m/s', 'doc': 'reference velocity in the body frame', 'source': 'eq. (velErr)',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_0', 'eta_1', 'eta_2', 'eta_3',
'eta_4', 'eta_5', 'eta_6', 'eta_7', 'eta_8'], 'lines': [['eta_0', 'g_e_0*nu_r_0 + g_e_4*nu_r_1 +
g_e_8*nu_r_2'], ['eta_1', 'g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2'], ['eta_2', 'g_e_10*nu_r_2 +
g_e_2*nu_r_0 + g_e_6*nu_r_1'], ['eta_3', 'eta_arm_0_a_0*g_e_0 + eta_arm_0_a_1*g_e_4 +
eta_arm_0_a_2*g_e_8'], ['eta_4', 'eta_arm_0_a_0*g_e_1 + eta_arm_0_a_1*g_e_5 + eta_arm_0_a_2*g_e_9'],
['eta_5', 'eta_arm_0_a_0*g_e_2 + eta_arm_0_a_1*g_e_6 + eta_arm_0_a_2*g_e_10'], ['eta_6',
'g_e_16*nu_r_6 + g_e_19*nu_r_7 + g_e_22*nu_r_8'], ['eta_7', 'g_e_17*nu_r_6 + g_e_20*nu_r_7 +
g_e_23*nu_r_8'], ['eta_8', 'g_e_18*nu_r_6 + g_e_21*nu_r_7 + g_e_24*nu_r_8']], 'cases': []}, {'name':
'nu_e', 'size': 9, 'unit': 'rad/s, m/s', 'doc': 'velocity error', 'source': 'eq. (velErr)',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['nu_e_0', 'nu_e_1', 'nu_e_2', 'nu_e_3',
'nu_e_4', 'nu_e_5', 'nu_e_6', 'nu_e_7', 'nu_e_8'], 'lines': [['nu_e_0', 'nu_0 - eta_0'], ['nu_e_1',
'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2'], ['nu_e_3', 'nu_3 - eta_3'], ['nu_e_4', 'nu_4 - eta_4'],
['nu_e_5', 'nu_5 - eta_5'], ['nu_e_6', 'nu_6 - eta_6'], ['nu_e_7', 'nu_7 - eta_7'], ['nu_e_8', 'nu_8
- eta_8']], 'cases': []}, {'name': 'eta_dot_arm_0_a', 'size': 3, 'unit': 'm/s', 'doc': 'velocity at
p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_dot_arm_0_a_0',
'eta_dot_arm_0_a_1', 'eta_dot_arm_0_a_2'], 'lines': [['eta_dot_arm_0_a_0', 'nu_r_dot_3 +
g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2'], ['eta_dot_arm_0_a_1', 'nu_r_dot_4 + g_e_3*nu_r_dot_2 -
g_e_11*nu_r_dot_0'], ['eta_dot_arm_0_a_2', 'nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1']],
'cases': []}, {'name': 'eta_dot', 'size': 9, 'unit': 'rad/s^2, m/s^2', 'doc': 'exact rate of eta',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['eta_dot_0', 'eta_dot_1',
'eta_dot_2', 'eta_dot_3', 'eta_dot_4', 'eta_dot_5', 'eta_dot_6', 'eta_dot_7', 'eta_dot_8'], 'lines':
[['eta_dot_0', 'eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2
- eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 +
g_e_6*nu_r_dot_1 - eta_1*nu_e_0'], ['eta_dot_3', 'eta_1*nu_e_5 + eta_4*nu_e_2 +
eta_dot_arm_0_a_0*g_e_0 + eta_dot_arm_0_a_1*g_e_4 + eta_dot_arm_0_a_2*g_e_8 - eta_2*nu_e_4 -
eta_5*nu_e_1'], ['eta_dot_4', 'eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_a_0*g_e_1 +
eta_dot_arm_0_a_1*g_e_5 + eta_dot_arm_0_a_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2'], ['eta_dot_5',
'eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_a_0*g_e_2 + eta_dot_arm_0_a_1*g_e_6 +
eta_dot_arm_0_a_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0'], ['eta_dot_6', 'eta_7*nu_e_8 +
g_e_16*nu_r_dot_6 + g_e_19*nu_r_dot_7 + g_e_22*nu_r_dot_8 - eta_8*nu_e_7'], ['eta_dot_7',
'eta_8*nu_e_6 + g_e_17*nu_r_dot_6 + g_e_20*nu_r_dot_7 + g_e_23*nu_r_dot_8 - eta_6*nu_e_8'],
['eta_dot_8', 'eta_6*nu_e_7 + g_e_18*nu_r_dot_6 + g_e_21*nu_r_dot_7 + g_e_24*nu_r_dot_8 -
eta_7*nu_e_6']], 'cases': []}, {'name': 'pairs_a', 'size': 4, 'unit': '1', 'doc': "what B's diagonal
is made of", 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['pairs_a_0',
'pairs_a_1', 'pairs_a_2', 'pairs_a_3'], 'lines': [['pairs_a_0', '1.0 + g_e_0'], ['pairs_a_1', '1.0 -
g_e_0'], ['pairs_a_2', 'g_e_10 + g_e_5'], ['pairs_a_3', 'g_e_5 - g_e_10']], 'cases': []}, {'name':
'B_a', 'size': 10, 'unit': '1', 'doc': '4 p p^T, p = (v, w), by rows', 'source': 'polar factor of
Markley and Bar-Itzhack', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['B_a_0',
'B_a_1', 'B_a_2', 'B_a_3', 'B_a_4', 'B_a_5', 'B_a_6', 'B_a_7', 'B_a_8', 'B_a_9'], 'lines':
[['B_a_0', 'pairs_a_0 - pairs_a_2'], ['B_a_1', 'g_e_1 + g_e_4'], ['B_a_2', 'g_e_2 + g_e_8'],
['B_a_3', 'g_e_9 - g_e_6'], ['B_a_4', 'pairs_a_1 + pairs_a_3'], ['B_a_5', 'g_e_6 + g_e_9'],
['B_a_6', 'g_e_2 - g_e_8'], ['B_a_7', 'pairs_a_1 - pairs_a_3'], ['B_a_8', 'g_e_4 - g_e_1'],
['B_a_9', 'pairs_a_0 + pairs_a_2']], 'cases': []}, {'name': 'column_a', 'size': 4, 'unit': '1',
'doc': 'a column of B that cannot vanish', 'source': '', 'is_scalar': False, 'holder': '', 'member':
'', 'names': ['column_a_0', 'column_a_1', 'column_a_2', 'column_a_3'], 'lines': [], 'cases':
[{'condition': 'B_a_9.real >= 1.0', 'lines': [['column_a_0', 'B_a_3'], ['column_a_1', 'B_a_6'],
['column_a_2', 'B_a_8'], ['column_a_3', 'B_a_9']]}, {'condition': '(B_a_0.real >= B_a_4.real) &
(B_a_0.real >= B_a_7.real)', 'lines': [['column_a_0', 'B_a_0'], ['column_a_1', 'B_a_1'],
['column_a_2', 'B_a_2'], ['column_a_3', 'B_a_3']]}, {'condition': 'B_a_4.real >= B_a_7.real',
'lines': [['column_a_0', 'B_a_1'], ['column_a_1', 'B_a_4'], ['column_a_2', 'B_a_5'], ['column_a_3',
'B_a_6']]}, {'condition': '', 'lines': [['column_a_0', 'B_a_2'], ['column_a_1', 'B_a_5'],
['column_a_2', 'B_a_7'], ['column_a_3', 'B_a_8']]}]}, {'name': 'power_a', 'size': 4, 'unit': '1',
'doc': 'the column after one power step', 'source': '', 'is_scalar': False, 'holder': '', 'member':
'', 'names': ['power_a_0', 'power_a_1', 'power_a_2', 'power_a_3'], 'lines': [['power_a_0',
'B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 + B_a_3*column_a_3'], ['power_a_1',
'B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 + B_a_6*column_a_3'], ['power_a_2',
'B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 + B_a_8*column_a_3'], ['power_a_3',
'B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 + B_a_9*column_a_3']], 'cases': []},
{'name': 'square_a', 'size': 1, 'unit': '1', 'doc': 'square of its vector part', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['square_a'], 'lines': [['square_a',
'power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2']], 'cases': []}, {'name':
'norm_square_a', 'size': 1, 'unit': '1', 'doc': 'its squared length', 'source': '', 'is_scalar':
True, 'holder': '', 'member': '', 'names': ['norm_square_a'], 'lines': [['norm_square_a', 'square_a
+ power_a_3*power_a_3']], 'cases': []}, {'name': 'norm_bounded_a', 'size': 1, 'unit': '1', 'doc':
'the same: less is no element', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['norm_bounded_a'], 'lines': [], 'cases': [{'condition': 'norm_square_a.real < 49.0',
'lines': [['norm_bounded_a', '49.0']]}, {'condition': '', 'lines': [['norm_bounded_a',
'norm_square_a']]}]}, {'name': 'norm_a', 'size': 1, 'unit': '1', 'doc': 'its length', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['norm_a'], 'lines': [['norm_a',
'np.sqrt(norm_bounded_a)']], 'cases': []}, {'name': 'inverse_norm_a', 'size': 1, 'unit': '1', 'doc':
'to unit length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['inverse_norm_a'], 'lines': [['inverse_norm_a', '1.0/norm_a']], 'cases': []}, {'name': 'scale_a',
'size': 1, 'unit': '1', 'doc': 'to unit length, and to w >= 0: the shorter way round', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['scale_a'], 'lines': [], 'cases':
[{'condition': 'power_a_3.real < 0.0', 'lines': [['scale_a', '-inverse_norm_a']]}, {'condition': '',
'lines': [['scale_a', 'inverse_norm_a']]}]}, {'name': 'cosine_a', 'size': 1, 'unit': '1', 'doc':
'cos of half the error angle, rounded', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['cosine_a'], 'lines': [['cosine_a', 'power_a_3*scale_a']], 'cases': []}, {'name': 'w_a',
'size': 1, 'unit': '1', 'doc': 'cos of half the error angle', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['w_a'], 'lines': [], 'cases': [{'condition': 'cosine_a.real >
1.0', 'lines': [['w_a', '1.0']]}, {'condition': '', 'lines': [['w_a', 'cosine_a']]}]}, {'name':
'v_a', 'size': 3, 'unit': '1', 'doc': 'sin of half the error angle times its axis', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['v_a_0', 'v_a_1', 'v_a_2'], 'lines':
[['v_a_0', 'power_a_0*scale_a'], ['v_a_1', 'power_a_1*scale_a'], ['v_a_2', 'power_a_2*scale_a']],
'cases': []}, {'name': 'k_a', 'size': 1, 'unit': '1', 'doc': 'half angle over its sine', 'source':
'', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['k_a'], 'lines': [['k_a', '_k(w_a)']],
'cases': []}, {'name': 'h_a', 'size': 1, 'unit': '1', 'doc': '-dk/dw', 'source': '', 'is_scalar':
True, 'holder': '', 'member': '', 'names': ['h_a'], 'lines': [['h_a', '_h(w_a)']], 'cases': []},
{'name': 'phi_a', 'size': 3, 'unit': 'rad', 'doc': 'rotation vector of the error', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['phi_a_0', 'phi_a_1', 'phi_a_2'], 'lines':
[['phi_a_0', '2.0*k_a*v_a_0'], ['phi_a_1', '2.0*k_a*v_a_1'], ['phi_a_2', '2.0*k_a*v_a_2']], 'cases':
[]}, {'name': 'half_a', 'size': 1, 'unit': '1', 'doc': '1/(2 k)', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['half_a'], 'lines': [['half_a', '0.5/k_a']], 'cases': []},
{'name': 'swing_p_a', 'size': 3, 'unit': 'm', 'doc': 'Y p', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['swing_p_a_0', 'swing_p_a_1', 'swing_p_a_2'], 'lines':
[['swing_p_a_0', 'g_e_11*v_a_1 - g_e_7*v_a_2'], ['swing_p_a_1', 'g_e_3*v_a_2 - g_e_11*v_a_0'],
['swing_p_a_2', 'g_e_7*v_a_0 - g_e_3*v_a_1']], 'cases': []}, {'name': 'sway_p_a', 'size': 3, 'unit':
'm', 'doc': 'Y Y p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['sway_p_a_0', 'sway_p_a_1', 'sway_p_a_2'], 'lines': [['sway_p_a_0', 'swing_p_a_2*v_a_1 -
swing_p_a_1*v_a_2'], ['sway_p_a_1', 'swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0'], ['sway_p_a_2',
'swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1']], 'cases': []}, {'name': 'rho_p_a', 'size': 3, 'unit': 'm',
'doc': 'p - k Y p + h Y Y p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['rho_p_a_0', 'rho_p_a_1', 'rho_p_a_2'], 'lines': [['rho_p_a_0', 'g_e_3 + h_a*sway_p_a_0 -
k_a*swing_p_a_0'], ['rho_p_a_1', 'g_e_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1'], ['rho_p_a_2', 'g_e_11
+ h_a*sway_p_a_2 - k_a*swing_p_a_2']], 'cases': []}, {'name': 'y_p_a', 'size': 3, 'unit': 'm',
'doc': 'rho/(2 k)', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['y_p_a_0', 'y_p_a_1', 'y_p_a_2'], 'lines': [['y_p_a_0', 'half_a*rho_p_a_0'], ['y_p_a_1',
'half_a*rho_p_a_1'], ['y_p_a_2', 'half_a*rho_p_a_2']], 'cases': []}, {'name': 'pairs_b', 'size': 4,
'unit': '1', 'doc': "what B's diagonal is made of", 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['pairs_b_0', 'pairs_b_1', 'pairs_b_2', 'pairs_b_3'], 'lines': [['pairs_b_0',
'1.0 + g_e_16'], ['pairs_b_1', '1.0 - g_e_16'], ['pairs_b_2', 'g_e_20 + g_e_24'], ['pairs_b_3',
'g_e_20 - g_e_24']], 'cases': []}, {'name': 'B_b', 'size': 10, 'unit': '1', 'doc': '4 p p^T, p = (v,
w), by rows', 'source': 'polar factor of Markley and Bar-Itzhack', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['B_b_0', 'B_b_1', 'B_b_2', 'B_b_3', 'B_b_4', 'B_b_5', 'B_b_6', 'B_b_7',
'B_b_8', 'B_b_9'], 'lines': [['B_b_0', 'pairs_b_0 - pairs_b_2'], ['B_b_1', 'g_e_17 + g_e_19'],
['B_b_2', 'g_e_18 + g_e_22'], ['B_b_3', 'g_e_23 - g_e_21'], ['B_b_4', 'pairs_b_1 + pairs_b_3'],
['B_b_5', 'g_e_21 + g_e_23'], ['B_b_6', 'g_e_18 - g_e_22'], ['B_b_7', 'pairs_b_1 - pairs_b_3'],
['B_b_8', 'g_e_19 - g_e_17'], ['B_b_9', 'pairs_b_0 + pairs_b_2']], 'cases': []}, {'name':
'column_b', 'size': 4, 'unit': '1', 'doc': 'a column of B that cannot vanish', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['column_b_0', 'column_b_1', 'column_b_2',
'column_b_3'], 'lines': [], 'cases': [{'condition': 'B_b_9.real >= 1.0', 'lines': [['column_b_0',
'B_b_3'], ['column_b_1', 'B_b_6'], ['column_b_2', 'B_b_8'], ['column_b_3', 'B_b_9']]}, {'condition':
'(B_b_0.real >= B_b_4.real) & (B_b_0.real >= B_b_7.real)', 'lines': [['column_b_0', 'B_b_0'],
['column_b_1', 'B_b_1'], ['column_b_2', 'B_b_2'], ['column_b_3', 'B_b_3']]}, {'condition':
'B_b_4.real >= B_b_7.real', 'lines': [['column_b_0', 'B_b_1'], ['column_b_1', 'B_b_4'],
['column_b_2', 'B_b_5'], ['column_b_3', 'B_b_6']]}, {'condition': '', 'lines': [['column_b_0',
'B_b_2'], ['column_b_1', 'B_b_5'], ['column_b_2', 'B_b_7'], ['column_b_3', 'B_b_8']]}]}, {'name':
'power_b', 'size': 4, 'unit': '1', 'doc': 'the column after one power step', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['power_b_0', 'power_b_1', 'power_b_2',
'power_b_3'], 'lines': [['power_b_0', 'B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 +
B_b_3*column_b_3'], ['power_b_1', 'B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 +
B_b_6*column_b_3'], ['power_b_2', 'B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 +
B_b_8*column_b_3'], ['power_b_3', 'B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 +
B_b_9*column_b_3']], 'cases': []}, {'name': 'square_b', 'size': 1, 'unit': '1', 'doc': 'square of
its vector part', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['square_b'], 'lines': [['square_b', 'power_b_0*power_b_0 + power_b_1*power_b_1 +
power_b_2*power_b_2']], 'cases': []}, {'name': 'norm_square_b', 'size': 1, 'unit': '1', 'doc': 'its
squared length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['norm_square_b'], 'lines': [['norm_square_b', 'square_b + power_b_3*power_b_3']], 'cases': []},
{'name': 'norm_bounded_b', 'size': 1, 'unit': '1', 'doc': 'the same: less is no element', 'source':
'', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['norm_bounded_b'], 'lines': [],
'cases': [{'condition': 'norm_square_b.real < 49.0', 'lines': [['norm_bounded_b', '49.0']]},
{'condition': '', 'lines': [['norm_bounded_b', 'norm_square_b']]}]}, {'name': 'norm_b', 'size': 1,
'unit': '1', 'doc': 'its length', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['norm_b'], 'lines': [['norm_b', 'np.sqrt(norm_bounded_b)']], 'cases': []}, {'name':
'inverse_norm_b', 'size': 1, 'unit': '1', 'doc': 'to unit length', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['inverse_norm_b'], 'lines': [['inverse_norm_b',
'1.0/norm_b']], 'cases': []}, {'name': 'scale_b', 'size': 1, 'unit': '1', 'doc': 'to unit length,
and to w >= 0: the shorter way round', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['scale_b'], 'lines': [], 'cases': [{'condition': 'power_b_3.real < 0.0', 'lines':
[['scale_b', '-inverse_norm_b']]}, {'condition': '', 'lines': [['scale_b', 'inverse_norm_b']]}]},
{'name': 'w_b', 'size': 1, 'unit': '1', 'doc': 'cos of half the error angle', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['w_b'], 'lines': [['w_b',
'power_b_3*scale_b']], 'cases': []}, {'name': 'k_b', 'size': 1, 'unit': '1', 'doc': 'half angle over
its sine', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['k_b'], 'lines':
[['k_b', '_k(w_b)']], 'cases': []}, {'name': 'h_raw_b', 'size': 1, 'unit': '1', 'doc': "-dk/dw by
the scale's square, as s^2 h = 1 - w k", 'source': '', 'is_scalar': True, 'holder': '', 'member':
'', 'names': ['h_raw_b'], 'lines': [['h_raw_b', '(1.0 - k_b*w_b)/(square_b + 1.0e-17)']], 'cases':
[]}, {'name': 'reach_b', 'size': 1, 'unit': '1', 'doc': 'p by the scale, but for a number',
'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['reach_b'], 'lines':
[['reach_b', 'k_b*scale_b']], 'cases': []}, {'name': 'stretch_b', 'size': 1, 'unit': '1', 'doc':
'ratio of nu_u to the vector part', 'source': '', 'is_scalar': True, 'holder': '', 'member': '',
'names': ['stretch_b'], 'lines': [['stretch_b', '2.0*reach_b']], 'cases': []}, {'name':
'clearance_0', 'size': 1, 'unit': '1', 'doc': 'the smaller clearance', 'source': '', 'is_scalar':
True, 'holder': '', 'member': '', 'names': ['clearance_0'], 'lines': [], 'cases': [{'condition':
'w_a.real <= w_b.real', 'lines': [['clearance_0', 'w_a']]}, {'condition': '', 'lines':
[['clearance_0', 'w_b']]}]}, {'name': 'nu_u', 'size': 9, 'unit': 'rad, m', 'doc': 'kinematic law,
the logarithm and the rotation vector', 'source': 'def. (KctrLaw)', 'is_scalar': False, 'holder':
'', 'member': '', 'names': ['nu_u_6', 'nu_u_7', 'nu_u_8'], 'lines': [['nu_u_6',
'power_b_0*stretch_b'], ['nu_u_7', 'power_b_1*stretch_b'], ['nu_u_8', 'power_b_2*stretch_b']],
'cases': []}, {'name': 'turn_a', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'Y nu_e, Y = ad of y',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['turn_a_0', 'turn_a_1',
'turn_a_2', 'turn_a_3', 'turn_a_4', 'turn_a_5'], 'lines': [['turn_a_0', 'nu_e_2*v_a_1 -
nu_e_1*v_a_2'], ['turn_a_1', 'nu_e_0*v_a_2 - nu_e_2*v_a_0'], ['turn_a_2', 'nu_e_1*v_a_0 -
nu_e_0*v_a_1'], ['turn_a_3', 'nu_e_2*y_p_a_1 + nu_e_5*v_a_1 - nu_e_1*y_p_a_2 - nu_e_4*v_a_2'],
['turn_a_4', 'nu_e_0*y_p_a_2 + nu_e_3*v_a_2 - nu_e_2*y_p_a_0 - nu_e_5*v_a_0'], ['turn_a_5',
'nu_e_1*y_p_a_0 + nu_e_4*v_a_0 - nu_e_0*y_p_a_1 - nu_e_3*v_a_1']], 'cases': []}, {'name': 'bend_a',
'size': 6, 'unit': 'rad/s, m/s', 'doc': 'Y Y nu_e', 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['bend_a_0', 'bend_a_1', 'bend_a_2', 'bend_a_3', 'bend_a_4', 'bend_a_5'],
'lines': [['bend_a_0', 'turn_a_2*v_a_1 - turn_a_1*v_a_2'], ['bend_a_1', 'turn_a_0*v_a_2 -
turn_a_2*v_a_0'], ['bend_a_2', 'turn_a_1*v_a_0 - turn_a_0*v_a_1'], ['bend_a_3', 'turn_a_2*y_p_a_1 +
turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2'], ['bend_a_4', 'turn_a_0*y_p_a_2 +
turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0'], ['bend_a_5', 'turn_a_1*y_p_a_0 +
turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1']], 'cases': []}, {'name': 'm_a', 'size': 1,
'unit': '1', 'doc': '-dh/dw', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['m_a'], 'lines': [['m_a', '_m(w_a)']], 'cases': []}, {'name': 'along_p_a', 'size': 1, 'unit': 'm',
'doc': '-2 v.q', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['along_p_a'], 'lines': [['along_p_a', '-2.0*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2)']],
'cases': []}, {'name': 'tail_a', 'size': 6, 'unit': 'rad/s, m/s', 'doc': '(Y^2 + s^2) Y^2 nu_e',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['tail_a_3', 'tail_a_4',
'tail_a_5'], 'lines': [['tail_a_3', 'along_p_a*bend_a_0'], ['tail_a_4', 'along_p_a*bend_a_1'],
['tail_a_5', 'along_p_a*bend_a_2']], 'cases': []}, {'name': 'twofold_a', 'size': 1, 'unit': '1',
'doc': 'h^2 - k m/2, of the double root', 'source': '', 'is_scalar': True, 'holder': '', 'member':
'', 'names': ['twofold_a'], 'lines': [['twofold_a', 'h_a*h_a - 0.5*k_a*m_a']], 'cases': []},
{'name': 'turn_b', 'size': 3, 'unit': 'rad/s', 'doc': 'vector part x nu_e, its share', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['turn_b_0', 'turn_b_1', 'turn_b_2'],
'lines': [['turn_b_0', 'nu_e_8*power_b_1 - nu_e_7*power_b_2'], ['turn_b_1', 'nu_e_6*power_b_2 -
nu_e_8*power_b_0'], ['turn_b_2', 'nu_e_7*power_b_0 - nu_e_6*power_b_1']], 'cases': []}, {'name':
'bend_b', 'size': 3, 'unit': 'rad/s', 'doc': 'vector part x that', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['bend_b_0', 'bend_b_1', 'bend_b_2'], 'lines': [['bend_b_0',
'power_b_1*turn_b_2 - power_b_2*turn_b_1'], ['bend_b_1', 'power_b_2*turn_b_0 - power_b_0*turn_b_2'],
['bend_b_2', 'power_b_0*turn_b_1 - power_b_1*turn_b_0']], 'cases': []}, {'name': 'nu_u_dot', 'size':
9, 'unit': 'rad/s, m/s', 'doc': 'exact rate of nu_u', 'source': '', 'is_scalar': False, 'holder':
'', 'member': '', 'names': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3', 'nu_u_dot_4',
'nu_u_dot_5', 'nu_u_dot_6', 'nu_u_dot_7', 'nu_u_dot_8'], 'lines': [['nu_u_dot_0', 'nu_e_0 +
bend_a_0*h_a + k_a*turn_a_0'], ['nu_u_dot_1', 'nu_e_1 + bend_a_1*h_a + k_a*turn_a_1'],
['nu_u_dot_2', 'nu_e_2 + bend_a_2*h_a + k_a*turn_a_2'], ['nu_u_dot_3', 'nu_e_3 + bend_a_3*h_a +
k_a*turn_a_3 + tail_a_3*twofold_a'], ['nu_u_dot_4', 'nu_e_4 + bend_a_4*h_a + k_a*turn_a_4 +
tail_a_4*twofold_a'], ['nu_u_dot_5', 'nu_e_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a'],
['nu_u_dot_6', 'nu_e_6 + bend_b_0*h_raw_b + reach_b*turn_b_0'], ['nu_u_dot_7', 'nu_e_7 +
bend_b_1*h_raw_b + reach_b*turn_b_1'], ['nu_u_dot_8', 'nu_e_8 + bend_b_2*h_raw_b +
reach_b*turn_b_2']], 'cases': []}, {'name': 'drive', 'size': 9, 'unit': 'rad/s, m/s', 'doc': 'lambda
nu_u', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['drive_0', 'drive_1',
'drive_2', 'drive_3', 'drive_4', 'drive_5', 'drive_6', 'drive_7', 'drive_8'], 'lines': [['drive_0',
'phi_a_0*rate_gain'], ['drive_1', 'phi_a_1*rate_gain'], ['drive_2', 'phi_a_2*rate_gain'],
['drive_3', 'rate_gain*rho_p_a_0'], ['drive_4', 'rate_gain*rho_p_a_1'], ['drive_5',
'rate_gain*rho_p_a_2'], ['drive_6', 'nu_u_6*rate_gain'], ['drive_7', 'nu_u_7*rate_gain'],
['drive_8', 'nu_u_8*rate_gain']], 'cases': []}, {'name': 's', 'size': 9, 'unit': 'rad/s, m/s',
'doc': 'sliding variable', 'source': 'eq. (SurfaceErr)', 'is_scalar': False, 'holder': '', 'member':
'', 'names': ['s_0', 's_1', 's_2', 's_3', 's_4', 's_5', 's_6', 's_7', 's_8'], 'lines': [['s_0',
'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2'], ['s_3', 'drive_3 +
nu_e_3'], ['s_4', 'drive_4 + nu_e_4'], ['s_5', 'drive_5 + nu_e_5'], ['s_6', 'drive_6 + nu_e_6'],
['s_7', 'drive_7 + nu_e_7'], ['s_8', 'drive_8 + nu_e_8']], 'cases': []}, {'name': 'wanted', 'size':
9, 'unit': 'rad/s^2, m/s^2', 'doc': 'acceleration asked for', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['wanted_0', 'wanted_1', 'wanted_2', 'wanted_3', 'wanted_4',
'wanted_5', 'wanted_6', 'wanted_7', 'wanted_8'], 'lines': [['wanted_0', 'eta_dot_0 -
nu_u_dot_0*rate_gain - reach_gain*s_0'], ['wanted_1', 'eta_dot_1 - nu_u_dot_1*rate_gain -
reach_gain*s_1'], ['wanted_2', 'eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2'], ['wanted_3',
'eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3'], ['wanted_4', 'eta_dot_4 - nu_u_dot_4*rate_gain
- reach_gain*s_4'], ['wanted_5', 'eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5'], ['wanted_6',
'eta_dot_6 - nu_u_dot_6*rate_gain - reach_gain*s_6'], ['wanted_7', 'eta_dot_7 - nu_u_dot_7*rate_gain
- reach_gain*s_7'], ['wanted_8', 'eta_dot_8 - nu_u_dot_8*rate_gain - reach_gain*s_8']], 'cases':
[]}, {'name': 'turning', 'size': 9, 'unit': 'rad/s, m/s', 'doc': 'lambda nu_u - eta, as s - nu',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['turning_0', 'turning_1',
'turning_2', 'turning_3', 'turning_4', 'turning_5', 'turning_6', 'turning_7', 'turning_8'], 'lines':
[['turning_0', 's_0 - nu_0'], ['turning_1', 's_1 - nu_1'], ['turning_2', 's_2 - nu_2'],
['turning_3', 's_3 - nu_3'], ['turning_4', 's_4 - nu_4'], ['turning_5', 's_5 - nu_5'], ['turning_6',
's_6 - nu_6'], ['turning_7', 's_7 - nu_7'], ['turning_8', 's_8 - nu_8']], 'cases': []}, {'name':
'momentum', 'size': 9, 'unit': 'N m s, N s', 'doc': 'I nu', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['momentum_0', 'momentum_1', 'momentum_2', 'momentum_3',
'momentum_4', 'momentum_5', 'momentum_6', 'momentum_7', 'momentum_8'], 'lines': [['momentum_0',
'inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4'], ['momentum_1', 'inertia_11*nu_3 +
inertia_9*nu_1'], ['momentum_2', 'inertia_17*nu_2 + inertia_2*nu_0'], ['momentum_3',
'inertia_11*nu_1 + inertia_24*nu_3'], ['momentum_4', 'inertia_30*nu_4 + inertia_4*nu_0'],
['momentum_5', 'inertia_35*nu_5'], ['momentum_6', 'inertia_39*nu_6'], ['momentum_7',
'inertia_42*nu_7'], ['momentum_8', 'inertia_44*nu_8']], 'cases': []}, {'name': 'force', 'size': 9,
'unit': 'N m, N', 'doc': 'control force, I f_u', 'source': 'eq. (TckCtrl)', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['force_0', 'force_1', 'force_2', 'force_3', 'force_4',
'force_5', 'force_6', 'force_7', 'force_8'], 'lines': [['force_0', 'inertia_0*wanted_0 +
inertia_2*wanted_2 + inertia_4*wanted_4 + momentum_1*turning_2 + momentum_4*turning_5 -
momentum_2*turning_1 - momentum_5*turning_4'], ['force_1', 'inertia_11*wanted_3 + inertia_9*wanted_1
+ momentum_2*turning_0 + momentum_5*turning_3 - momentum_0*turning_2 - momentum_3*turning_5'],
['force_2', 'inertia_17*wanted_2 + inertia_2*wanted_0 + momentum_0*turning_1 + momentum_3*turning_4
- momentum_1*turning_0 - momentum_4*turning_3'], ['force_3', 'inertia_11*wanted_1 +
inertia_24*wanted_3 + momentum_4*turning_2 - momentum_5*turning_1'], ['force_4',
'inertia_30*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 - momentum_3*turning_2'],
['force_5', 'inertia_35*wanted_5 + momentum_3*turning_1 - momentum_4*turning_0'], ['force_6',
'inertia_39*wanted_6 + momentum_7*turning_8 - momentum_8*turning_7'], ['force_7',
'inertia_42*wanted_7 + momentum_8*turning_6 - momentum_6*turning_8'], ['force_8',
'inertia_44*wanted_8 + momentum_6*turning_7 - momentum_7*turning_6']], 'cases': []}], 'outputs':
[{'name': 'force', 'size': 9, 'unit': 'N m, N', 'doc': 'control force', 'source': '', 'is_scalar':
False, 'holder': 'command', 'member': 'force', 'entries': ['force_0', 'force_1', 'force_2',
'force_3', 'force_4', 'force_5', 'force_6', 'force_7', 'force_8']}, {'name': 's', 'size': 9, 'unit':
'rad/s, m/s', 'doc': 'sliding variable', 'source': '', 'is_scalar': False, 'holder': 'command',
'member': 's', 'entries': ['s_0', 's_1', 's_2', 's_3', 's_4', 's_5', 's_6', 's_7', 's_8']}, {'name':
'nu_u', 'size': 9, 'unit': 'rad, m', 'doc': 'kinematic law', 'source': '', 'is_scalar': False,
'holder': 'command', 'member': 'nu_u', 'entries': ['phi_a_0', 'phi_a_1', 'phi_a_2', 'rho_p_a_0',
'rho_p_a_1', 'rho_p_a_2', 'nu_u_6', 'nu_u_7', 'nu_u_8']}, {'name': 'nu_u_dot', 'size': 9, 'unit':
'rad/s, m/s', 'doc': 'its exact rate', 'source': '', 'is_scalar': False, 'holder': 'command',
'member': 'nu_u_dot', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3',
'nu_u_dot_4', 'nu_u_dot_5', 'nu_u_dot_6', 'nu_u_dot_7', 'nu_u_dot_8']}, {'name': 'clearance',
'size': 1, 'unit': '1', 'doc': 'distance from the cut locus of the law', 'source': '', 'is_scalar':
True, 'holder': '', 'member': 'clearance', 'entries': ['clearance_0']}], 'operations': 614,
'temporaries': 208, 'symbol': 'tracking', 'is_public': False, 'holders': ['params', 'state',
'reference'], 'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'], 'has_reference': True, 'writes':
['command', 'clearance'], 'public_writes': ['command', 'clearance']}, double precision, batched.

Generated by derive from the vehicle file two_bodies.toml; regenerate instead of editing.
Configuration: matrix of 4 rows, row by row; then rotation matrix, row by row.
Velocities and forces are in the body frame, the reference velocity in the reference body
frame. Every argument and every field of Params broadcasts over leading axes.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

MAX_INPUT = 1.0e6  # largest magnitude of a number in state or reference
MAX_ENTRY = 1.01  # of an entry of the error that the group keeps at 1
MAX_REACH = 4.0e6  # of any other entry of the error
MOST_DRIFT = 0.1  # largest max_drift that may be asked for
NEAR_CUT = 0.001  # clearance below which NEAR_CUT_LOCUS is flagged
REFUSED_CUT = 1.0e-8  # clearance below which a law with a pole is refused
MAX_PARAM = 1.0e9  # largest inertia entry, force limit, or other gain
MIN_GAIN = 1.0e-9  # least gain
MAX_RATE = 1.0e4  # largest gain in 1/s

OK = 0  # the command is good
SATURATED = 1  # a force limit was reached
NEAR_CUT_LOCUS = 2  # the error is close to where the law jumps
NOT_ON_GROUP = 16  # the error is off the group by more than max_drift
OUT_OF_RANGE = 17  # beyond MAX_INPUT, or too near a pole of the law
NONFINITE_INPUT = 18  # an input, or what it leads to, is not finite
BAD_PARAMS = 19  # found by check_params

BOUNDS = (MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_REACH, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_REACH,
          MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_REACH, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY,
          MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY,
          MAX_ENTRY)  # of the error's entries
FREE = np.array(BOUNDS) > MAX_ENTRY
CHUNK = 4096  # rows computed together, so that their temporaries stay in the cache
Array = Any  # a numpy array, or what np.asarray makes one of


class Params(NamedTuple):
    """Inertia, upper triangle row by row (..., 45), and gains, each (...).

    What `control` keeps to has the vehicle's values where it is left out.
    """

    inertia: Array
    lambda_: Array
    k_s: Array
    max_drift: Array = 1.0e-6  # largest distance of the error from the group [1]


class Command(NamedTuple):
    """Force, sliding variable, law and its exact rate, (..., 9) each; status (...)."""

    force: Array
    s: Array
    nu_u: Array
    nu_u_dot: Array
    status: Array


DEFAULTS = Params(
    inertia=(0.1827, 0.0, 0.004, 0.0, -0.18, 0.0, 0.0, 0.0, 0.0, 0.2127, 0.0, 0.18, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.15, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 12.0, 0.0, 0.0, 0.0, 0.0, 0.0, 12.0, 0.0, 0.0,
        0.0, 0.0, 12.0, 0.0, 0.0, 0.0, 0.0421, 0.0, 0.0, 0.0417, 0.0, 0.0067),
    lambda_=0.08,
    k_s=0.3,
)


def control(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Guarded controller: force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).

    Arguments as for `tracking`, real numbers only, computed and judged in double; TypeError for
    others. Where the status is 16 or larger, the whole command is zero.
    """
    given = [
        _real("inertia", params.inertia, (45,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
        _real("g", g, (25,)),
        _real("nu", nu, (9,)),
        _real("g_r", g_r, (25,)),
        _real("nu_r", nu_r, (9,)),
        _real("nu_r_dot", nu_r_dot, (9,)),
    ]
    max_drift = _real("max_drift", params.max_drift, ())
    with np.errstate(all="ignore"):
        *command, clearance = _batched(_law, given)
        g_e = _batched(_error, [given[3], given[5]])[0]
        good = (np.abs(g_e) <= BOUNDS).all(-1)
        good = good & ((np.abs(given[3]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[4]) <= MAX_INPUT).all(-1)
        good = good & ((np.abs(given[5]) <= MAX_INPUT) | ~FREE).all(-1)
        good = good & (np.abs(given[6]) <= MAX_INPUT).all(-1)
        good = good & (np.abs(given[7]) <= MAX_INPUT).all(-1)
        good = good & (_batched(_drift, [g_e, given[3], given[5]])[0] <= max_drift * max_drift)[..., 0]
        status = np.where(np.isfinite(command[0]).all(-1), OK, NONFINITE_INPUT)
        near = np.where(clearance[..., 0] < NEAR_CUT, NEAR_CUT_LOCUS, OK)
        far = (~(np.abs(g_e) <= BOUNDS) & FREE).any(-1)
        refused = np.where(far, OUT_OF_RANGE, NOT_ON_GROUP)
        for rows in (given[3], given[4], given[5], given[6], given[7]):
            refused = np.maximum(refused, _judge(rows))
        status = np.where(good, np.maximum(status, near), refused)
    bad = (status >= 16)[..., None]
    return Command(*(np.where(bad, 0.0, one) for one in command), status)


def check_params(params: Params = DEFAULTS) -> Array:
    """OK or BAD_PARAMS of each set of parameters, (...); real numbers only.

    BAD_PARAMS where a number is not finite or beyond MAX_PARAM, a gain is not positive, or the
    inertia is not positive definite, or not zero where the derivation took a zero for granted.
    """
    given = [
        _real("inertia", params.inertia, (45,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
    ]
    inertia, *gains = given
    with np.errstate(all="ignore"):
        pivots = _batched(_definiteness, [inertia])[0]
        good = (np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)
        good = good & (inertia[..., [1, 3, 5, 6, 7, 8, 10, 12, 13, 14, 15, 16, 18, 19, 20, 21, 22,
            23, 25, 26, 27, 28, 29, 31, 32, 33, 34, 36, 37, 38, 40, 41, 43]] == 0.0).all(-1)
        good = good & ((gains[0] >= MIN_GAIN) & (gains[0] <= MAX_RATE))[..., 0]
        good = good & ((gains[1] >= MIN_GAIN) & (gains[1] <= MAX_RATE))[..., 0]
        drift = _real("max_drift", params.max_drift, ())
        good = good & ((drift > 0.0) & (drift <= MOST_DRIFT))[..., 0]
    return np.where(good, OK, BAD_PARAMS)


def tracking(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl). Presumes what `control` checks.

    g: configuration: matrix of 4 rows, row by row; then rotation matrix, row by row [1], (..., 25)
    nu: body velocity [rad/s, m/s], (..., 9)
    g_r: reference configuration: matrix of 4 rows, row by row; then rotation matrix, row by row
        [1], (..., 25)
    nu_r: reference velocity, reference body frame [rad/s, m/s], (..., 9)
    nu_r_dot: its rate [rad/s^2, m/s^2], (..., 9)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (45,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (25,)),
        _rows("nu", nu, (9,)),
        _rows("g_r", g_r, (25,)),
        _rows("nu_r", nu_r, (9,)),
        _rows("nu_r_dot", nu_r_dot, (9,)),
    ]
    command = _batched(_law, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def reaching(
    g: Array, nu: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2). Presumes what `control` checks.

    g: configuration: matrix of 4 rows, row by row; then rotation matrix, row by row [1], (..., 25)
    nu: body velocity [rad/s, m/s], (..., 9)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (45,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (25,)),
        _rows("nu", nu, (9,)),
    ]
    command = _batched(_reaching, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def plant(
    nu: Array, force: Array, params: Params = DEFAULTS
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP). Presumes what `control` checks.

    nu: body velocity [rad/s, m/s], (..., 9)
    force: applied force [N m, N], (..., 9)
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (45,)),
        _rows("nu", nu, (9,)),
        _rows("force", force, (9,)),
    ]
    return _batched(_plant, given)[0]


def _real(name: str, value: Array, shape: tuple[int, ...]) -> Array:
    """As _rows, in double; TypeError for a mask, and for what is not real numbers."""
    array = np.asarray(value)
    is_masked = isinstance(value, np.ma.MaskedArray)
    if is_masked or array.dtype.kind not in "biuf":
        found = "a masked array" if is_masked else f"an array of {array.dtype}"
        raise TypeError(f"{name}: expected real numbers, found {found}")
    with np.errstate(all="ignore"):  # beyond the largest double it is infinite, and so judged
        return _rows(name, array.astype(np.float64), shape)


def _rows(name: str, value: Array, shape: tuple[int, ...]) -> Array:
    """value (..., *shape) as (..., k); ValueError when its last axes are others."""
    array = np.asarray(value)
    split = array.ndim - len(shape)
    if array.shape[max(split, 0) :] != shape:
        wanted = ", ".join(map(str, shape))
        raise ValueError(f"{name}: expected an array (..., {wanted}), found {array.shape}")
    return array.reshape(*array.shape[:split], int(np.prod(shape)))


def _batched(law: Any, given: list[Array]) -> list[Array]:
    """Run a law over the broadcast leading axes, in chunks, each quantity as columns."""
    batch = np.broadcast_shapes(*(one.shape[:-1] for one in given))
    spread = [np.broadcast_to(one, (*batch, one.shape[-1])) for one in given]
    flat = [one.reshape(-1, one.shape[-1]) for one in spread]
    typed = [(one, np.result_type(one, np.float64)) for one in flat]  # float32 is too coarse
    dtype = np.result_type(np.float64, *given)
    outputs: list[Array] = []
    for start in range(0, max(1, len(flat[0])), CHUNK):
        chunk = slice(start, start + CHUNK)
        columns = law(*(np.ascontiguousarray(one[chunk].T, kind) for one, kind in typed))
        if not outputs:
            outputs = [np.empty((len(flat[0]), len(entries)), dtype) for entries in columns]
        for output, entries in zip(outputs, columns):
            for i, entry in enumerate(entries):
                output[chunk, i] = entry
    return [output.reshape(*batch, output.shape[-1]) for output in outputs]


def _judge(rows: Array) -> Array:
    """OK, OUT_OF_RANGE or NONFINITE_INPUT for each row, (...)."""
    status = np.where((np.abs(rows) > MAX_INPUT).any(-1), OUT_OF_RANGE, OK)
    return np.where(np.isfinite(rows).all(-1), status, NONFINITE_INPUT)


def _k(w: Array) -> Array:
    """Kernel function k(w) on 0 <= w <= 1, a polynomial in 1 - w."""
    z = 1.0 - w
    value = 8.277514146196502e-5
    value = value * z - 0.0007444806306887051
    value = value * z + 0.00317670645149068
    value = value * z - 0.008454515050142185
    value = value * z + 0.01566904108961398
    value = value * z - 0.02138402971876357
    value = value * z + 0.022234983575225374
    value = value * z - 0.01792610921286688
    value = value * z + 0.011402056638616778
    value = value * z - 0.005632546133953197
    value = value * z + 0.002377672542009468
    value = value * z - 0.0004366715134129454
    value = value * z + 0.0007243405609038858
    value = value * z + 0.0011382817325777553
    value = value * z + 0.0024908875171720216
    value = value * z + 0.0053275406688376775
    value = value * z + 0.01154404554160158
    value = value * z + 0.02539682373687369
    value = value * z + 0.05714285719245186
    value = value * z + 0.13333333333254913
    value = value * z + 0.33333333333333826
    value = value * z + 1.0
    return value


def _h(w: Array) -> Array:
    """Kernel function h(w) on 0 <= w <= 1, a polynomial in 1 - w."""
    z = 1.0 - w
    value = 0.0005869285541338526
    value = value * z - 0.005858782802349971
    value = value * z + 0.02775217181527643
    value = value * z - 0.08239871557949739
    value = value * z + 0.17141579919249336
    value = value * z - 0.2648054375312226
    value = value * z + 0.31451612336770063
    value = value * z - 0.2933687632591719
    value = value * z + 0.21795684792382322
    value = value * z - 0.12974666772406582
    value = value * z + 0.06249498320555255
    value = value * z - 0.023679806838676747
    value = value * z + 0.008179325052908947
    value = value * z - 0.00044990996254287995
    value = value * z + 0.0029965381931628668
    value = value * z + 0.00493433513118645
    value = value * z + 0.009366742351494562
    value = value * z + 0.01740429621188172
    value = value * z + 0.0319680631824094
    value = value * z + 0.05772005646930993
    value = value * z + 0.10158730161801939
    value = value * z + 0.17142857142817186
    value = value * z + 0.2666666666666687
    value = value * z + 0.3333333333333333
    return value


def _m(w: Array) -> Array:
    """Kernel function m(w) on 0 <= w <= 1, a polynomial in 1 - w."""
    z = 1.0 - w
    value = 0.005086617270586654
    value = value * z - 0.055706599747338964
    value = value * z + 0.28993069131182037
    value = value * z - 0.9497531819644951
    value = value * z + 2.191472343354955
    value = value * z - 3.7799407192384487
    value = value * z + 5.051152839252075
    value = value * z - 5.349819738530713
    value = value * z + 4.558603016452899
    value = value * z - 3.154192583107265
    value = value * z + 1.7828890332945444
    value = value * z - 0.8234877082783333
    value = value * z + 0.31320023890797616
    value = value * z - 0.09357070006098941
    value = value * z + 0.028572814006091584
    value = value * z + 0.0031765590861297516
    value = value * z + 0.014652333042480134
    value = value * z + 0.02365800843776174
    value = value * z + 0.03991463872482601
    value = value * z + 0.06552338456620405
    value = value * z + 0.1044289360435494
    value = value * z + 0.159840158783183
    value = value * z + 0.23088023090191748
    value = value * z + 0.304761904761669
    value = value * z + 0.34285714285714386
    value = value * z + 0.26666666666666666
    return value


def _law(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array, g_r: Array, nu_r: Array,
    nu_r_dot: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    (
        inertia_0, inertia_2, inertia_4, inertia_9, inertia_11, inertia_17, inertia_24, inertia_30,
        inertia_35, inertia_39, inertia_42, inertia_44,
    ) = (
        inertia[0], inertia[2], inertia[4], inertia[9], inertia[11], inertia[17], inertia[24],
        inertia[30], inertia[35], inertia[39], inertia[42], inertia[44]
    )
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    (
        g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11, g_16, g_17, g_18, g_19, g_20,
        g_21, g_22, g_23, g_24,
    ) = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11], g[16], g[17],
        g[18], g[19], g[20], g[21], g[22], g[23], g[24]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5, nu_6, nu_7, nu_8 = (
        nu[0], nu[1], nu[2], nu[3], nu[4], nu[5], nu[6], nu[7], nu[8]
    )
    (
        g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8, g_r_9, g_r_10, g_r_11,
        g_r_16, g_r_17, g_r_18, g_r_19, g_r_20, g_r_21, g_r_22, g_r_23, g_r_24,
    ) = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8], g_r[9], g_r[10],
        g_r[11], g_r[16], g_r[17], g_r[18], g_r[19], g_r[20], g_r[21], g_r[22], g_r[23], g_r[24]
    )
    nu_r_0, nu_r_1, nu_r_2, nu_r_3, nu_r_4, nu_r_5, nu_r_6, nu_r_7, nu_r_8 = (
        nu_r[0], nu_r[1], nu_r[2], nu_r[3], nu_r[4], nu_r[5], nu_r[6], nu_r[7], nu_r[8]
    )
    (
        nu_r_dot_0, nu_r_dot_1, nu_r_dot_2, nu_r_dot_3, nu_r_dot_4, nu_r_dot_5, nu_r_dot_6,
        nu_r_dot_7, nu_r_dot_8,
    ) = (
        nu_r_dot[0], nu_r_dot[1], nu_r_dot[2], nu_r_dot[3], nu_r_dot[4], nu_r_dot[5], nu_r_dot[6],
        nu_r_dot[7], nu_r_dot[8]
    )
    # gap_0_a: translation of g from g_r [m]
    gap_0_a_0 = g_3 - g_r_3
    gap_0_a_1 = g_7 - g_r_7
    gap_0_a_2 = g_11 - g_r_11
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8
    g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8
    g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4
    g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2
    g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9
    g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9
    g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5
    g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2
    g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10
    g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10
    g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6
    g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1
    g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22
    g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22
    g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22
    g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23
    g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23
    g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23
    g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24
    g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24
    g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24
    # eta_arm_0_a: velocity at p [m/s]
    eta_arm_0_a_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2
    eta_arm_0_a_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0
    eta_arm_0_a_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1
    # eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr)
    eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2
    eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2
    eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1
    eta_3 = eta_arm_0_a_0*g_e_0 + eta_arm_0_a_1*g_e_4 + eta_arm_0_a_2*g_e_8
    eta_4 = eta_arm_0_a_0*g_e_1 + eta_arm_0_a_1*g_e_5 + eta_arm_0_a_2*g_e_9
    eta_5 = eta_arm_0_a_0*g_e_2 + eta_arm_0_a_1*g_e_6 + eta_arm_0_a_2*g_e_10
    eta_6 = g_e_16*nu_r_6 + g_e_19*nu_r_7 + g_e_22*nu_r_8
    eta_7 = g_e_17*nu_r_6 + g_e_20*nu_r_7 + g_e_23*nu_r_8
    eta_8 = g_e_18*nu_r_6 + g_e_21*nu_r_7 + g_e_24*nu_r_8
    # nu_e: velocity error [rad/s, m/s], eq. (velErr)
    nu_e_0 = nu_0 - eta_0
    nu_e_1 = nu_1 - eta_1
    nu_e_2 = nu_2 - eta_2
    nu_e_3 = nu_3 - eta_3
    nu_e_4 = nu_4 - eta_4
    nu_e_5 = nu_5 - eta_5
    nu_e_6 = nu_6 - eta_6
    nu_e_7 = nu_7 - eta_7
    nu_e_8 = nu_8 - eta_8
    # eta_dot_arm_0_a: velocity at p [m/s]
    eta_dot_arm_0_a_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2
    eta_dot_arm_0_a_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0
    eta_dot_arm_0_a_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1
    # eta_dot: exact rate of eta [rad/s^2, m/s^2]
    eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 - eta_2*nu_e_1
    eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 - eta_0*nu_e_2
    eta_dot_2 = (
        eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 - eta_1*nu_e_0
    )
    eta_dot_3 = (
        eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_a_0*g_e_0 + eta_dot_arm_0_a_1*g_e_4 +
        eta_dot_arm_0_a_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1
    )
    eta_dot_4 = (
        eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_a_0*g_e_1 + eta_dot_arm_0_a_1*g_e_5 +
        eta_dot_arm_0_a_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2
    )
    eta_dot_5 = (
        eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_a_0*g_e_2 + eta_dot_arm_0_a_1*g_e_6 +
        eta_dot_arm_0_a_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0
    )
    eta_dot_6 = (
        eta_7*nu_e_8 + g_e_16*nu_r_dot_6 + g_e_19*nu_r_dot_7 + g_e_22*nu_r_dot_8 - eta_8*nu_e_7
    )
    eta_dot_7 = (
        eta_8*nu_e_6 + g_e_17*nu_r_dot_6 + g_e_20*nu_r_dot_7 + g_e_23*nu_r_dot_8 - eta_6*nu_e_8
    )
    eta_dot_8 = (
        eta_6*nu_e_7 + g_e_18*nu_r_dot_6 + g_e_21*nu_r_dot_7 + g_e_24*nu_r_dot_8 - eta_7*nu_e_6
    )
    # pairs_a: what B's diagonal is made of [1]
    pairs_a_0 = 1.0 + g_e_0
    pairs_a_1 = 1.0 - g_e_0
    pairs_a_2 = g_e_10 + g_e_5
    pairs_a_3 = g_e_5 - g_e_10
    # B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_a_0 = pairs_a_0 - pairs_a_2
    B_a_1 = g_e_1 + g_e_4
    B_a_2 = g_e_2 + g_e_8
    B_a_3 = g_e_9 - g_e_6
    B_a_4 = pairs_a_1 + pairs_a_3
    B_a_5 = g_e_6 + g_e_9
    B_a_6 = g_e_2 - g_e_8
    B_a_7 = pairs_a_1 - pairs_a_3
    B_a_8 = g_e_4 - g_e_1
    B_a_9 = pairs_a_0 + pairs_a_2
    # column_a: a column of B that cannot vanish [1]
    column_a_if_0 = B_a_9.real >= 1.0
    column_a_if_1 = (B_a_0.real >= B_a_4.real) & (B_a_0.real >= B_a_7.real)
    column_a_if_2 = B_a_4.real >= B_a_7.real
    column_a_0 = (
        np.where(column_a_if_0, B_a_3, np.where(column_a_if_1, B_a_0, np.where(column_a_if_2, B_a_1,
        B_a_2)))
    )
    column_a_1 = (
        np.where(column_a_if_0, B_a_6, np.where(column_a_if_1, B_a_1, np.where(column_a_if_2, B_a_4,
        B_a_5)))
    )
    column_a_2 = (
        np.where(column_a_if_0, B_a_8, np.where(column_a_if_1, B_a_2, np.where(column_a_if_2, B_a_5,
        B_a_7)))
    )
    column_a_3 = (
        np.where(column_a_if_0, B_a_9, np.where(column_a_if_1, B_a_3, np.where(column_a_if_2, B_a_6,
        B_a_8)))
    )
    # power_a: the column after one power step [1]
    power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 + B_a_3*column_a_3
    power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 + B_a_6*column_a_3
    power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 + B_a_8*column_a_3
    power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 + B_a_9*column_a_3
    # square_a: square of its vector part [1]
    square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2
    # norm_square_a: its squared length [1]
    norm_square_a = square_a + power_a_3*power_a_3
    # norm_bounded_a: the same: less is no element [1]
    norm_bounded_a_if_0 = norm_square_a.real < 49.0
    norm_bounded_a = np.where(norm_bounded_a_if_0, 49.0, norm_square_a)
    # norm_a: its length [1]
    norm_a = np.sqrt(norm_bounded_a)
    # inverse_norm_a: to unit length [1]
    inverse_norm_a = 1.0/norm_a
    # scale_a: to unit length, and to w >= 0: the shorter way round [1]
    scale_a_if_0 = power_a_3.real < 0.0
    scale_a = np.where(scale_a_if_0, -inverse_norm_a, inverse_norm_a)
    # cosine_a: cos of half the error angle, rounded [1]
    cosine_a = power_a_3*scale_a
    # w_a: cos of half the error angle [1]
    w_a_if_0 = cosine_a.real > 1.0
    w_a = np.where(w_a_if_0, 1.0, cosine_a)
    # v_a: sin of half the error angle times its axis [1]
    v_a_0 = power_a_0*scale_a
    v_a_1 = power_a_1*scale_a
    v_a_2 = power_a_2*scale_a
    # k_a: half angle over its sine [1]
    k_a = _k(w_a)
    # h_a: -dk/dw [1]
    h_a = _h(w_a)
    # phi_a: rotation vector of the error [rad]
    phi_a_0 = 2.0*k_a*v_a_0
    phi_a_1 = 2.0*k_a*v_a_1
    phi_a_2 = 2.0*k_a*v_a_2
    # half_a: 1/(2 k) [1]
    half_a = 0.5/k_a
    # swing_p_a: Y p [m]
    swing_p_a_0 = g_e_11*v_a_1 - g_e_7*v_a_2
    swing_p_a_1 = g_e_3*v_a_2 - g_e_11*v_a_0
    swing_p_a_2 = g_e_7*v_a_0 - g_e_3*v_a_1
    # sway_p_a: Y Y p [m]
    sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2
    sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0
    sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1
    # rho_p_a: p - k Y p + h Y Y p [m]
    rho_p_a_0 = g_e_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0
    rho_p_a_1 = g_e_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1
    rho_p_a_2 = g_e_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2
    # y_p_a: rho/(2 k) [m]
    y_p_a_0 = half_a*rho_p_a_0
    y_p_a_1 = half_a*rho_p_a_1
    y_p_a_2 = half_a*rho_p_a_2
    # pairs_b: what B's diagonal is made of [1]
    pairs_b_0 = 1.0 + g_e_16
    pairs_b_1 = 1.0 - g_e_16
    pairs_b_2 = g_e_20 + g_e_24
    pairs_b_3 = g_e_20 - g_e_24
    # B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_b_0 = pairs_b_0 - pairs_b_2
    B_b_1 = g_e_17 + g_e_19
    B_b_2 = g_e_18 + g_e_22
    B_b_3 = g_e_23 - g_e_21
    B_b_4 = pairs_b_1 + pairs_b_3
    B_b_5 = g_e_21 + g_e_23
    B_b_6 = g_e_18 - g_e_22
    B_b_7 = pairs_b_1 - pairs_b_3
    B_b_8 = g_e_19 - g_e_17
    B_b_9 = pairs_b_0 + pairs_b_2
    # column_b: a column of B that cannot vanish [1]
    column_b_if_0 = B_b_9.real >= 1.0
    column_b_if_1 = (B_b_0.real >= B_b_4.real) & (B_b_0.real >= B_b_7.real)
    column_b_if_2 = B_b_4.real >= B_b_7.real
    column_b_0 = (
        np.where(column_b_if_0, B_b_3, np.where(column_b_if_1, B_b_0, np.where(column_b_if_2, B_b_1,
        B_b_2)))
    )
    column_b_1 = (
        np.where(column_b_if_0, B_b_6, np.where(column_b_if_1, B_b_1, np.where(column_b_if_2, B_b_4,
        B_b_5)))
    )
    column_b_2 = (
        np.where(column_b_if_0, B_b_8, np.where(column_b_if_1, B_b_2, np.where(column_b_if_2, B_b_5,
        B_b_7)))
    )
    column_b_3 = (
        np.where(column_b_if_0, B_b_9, np.where(column_b_if_1, B_b_3, np.where(column_b_if_2, B_b_6,
        B_b_8)))
    )
    # power_b: the column after one power step [1]
    power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 + B_b_3*column_b_3
    power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 + B_b_6*column_b_3
    power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 + B_b_8*column_b_3
    power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 + B_b_9*column_b_3
    # square_b: square of its vector part [1]
    square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2
    # norm_square_b: its squared length [1]
    norm_square_b = square_b + power_b_3*power_b_3
    # norm_bounded_b: the same: less is no element [1]
    norm_bounded_b_if_0 = norm_square_b.real < 49.0
    norm_bounded_b = np.where(norm_bounded_b_if_0, 49.0, norm_square_b)
    # norm_b: its length [1]
    norm_b = np.sqrt(norm_bounded_b)
    # inverse_norm_b: to unit length [1]
    inverse_norm_b = 1.0/norm_b
    # scale_b: to unit length, and to w >= 0: the shorter way round [1]
    scale_b_if_0 = power_b_3.real < 0.0
    scale_b = np.where(scale_b_if_0, -inverse_norm_b, inverse_norm_b)
    # w_b: cos of half the error angle [1]
    w_b = power_b_3*scale_b
    # k_b: half angle over its sine [1]
    k_b = _k(w_b)
    # h_raw_b: -dk/dw by the scale's square, as s^2 h = 1 - w k [1]
    h_raw_b = (1.0 - k_b*w_b)/(square_b + 1.0e-17)
    # reach_b: p by the scale, but for a number [1]
    reach_b = k_b*scale_b
    # stretch_b: ratio of nu_u to the vector part [1]
    stretch_b = 2.0*reach_b
    # clearance_0: the smaller clearance [1]
    clearance_0_if_0 = w_a.real <= w_b.real
    clearance_0 = np.where(clearance_0_if_0, w_a, w_b)
    # nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw)
    nu_u_6 = power_b_0*stretch_b
    nu_u_7 = power_b_1*stretch_b
    nu_u_8 = power_b_2*stretch_b
    # turn_a: Y nu_e, Y = ad of y [rad/s, m/s]
    turn_a_0 = nu_e_2*v_a_1 - nu_e_1*v_a_2
    turn_a_1 = nu_e_0*v_a_2 - nu_e_2*v_a_0
    turn_a_2 = nu_e_1*v_a_0 - nu_e_0*v_a_1
    turn_a_3 = nu_e_2*y_p_a_1 + nu_e_5*v_a_1 - nu_e_1*y_p_a_2 - nu_e_4*v_a_2
    turn_a_4 = nu_e_0*y_p_a_2 + nu_e_3*v_a_2 - nu_e_2*y_p_a_0 - nu_e_5*v_a_0
    turn_a_5 = nu_e_1*y_p_a_0 + nu_e_4*v_a_0 - nu_e_0*y_p_a_1 - nu_e_3*v_a_1
    # bend_a: Y Y nu_e [rad/s, m/s]
    bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2
    bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0
    bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1
    bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2
    bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0
    bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1
    # m_a: -dh/dw [1]
    m_a = _m(w_a)
    # along_p_a: -2 v.q [m]
    along_p_a = -2.0*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2)
    # tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s]
    tail_a_3 = along_p_a*bend_a_0
    tail_a_4 = along_p_a*bend_a_1
    tail_a_5 = along_p_a*bend_a_2
    # twofold_a: h^2 - k m/2, of the double root [1]
    twofold_a = h_a*h_a - 0.5*k_a*m_a
    # turn_b: vector part x nu_e, its share [rad/s]
    turn_b_0 = nu_e_8*power_b_1 - nu_e_7*power_b_2
    turn_b_1 = nu_e_6*power_b_2 - nu_e_8*power_b_0
    turn_b_2 = nu_e_7*power_b_0 - nu_e_6*power_b_1
    # bend_b: vector part x that [rad/s]
    bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1
    bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2
    bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0
    # nu_u_dot: exact rate of nu_u [rad/s, m/s]
    nu_u_dot_0 = nu_e_0 + bend_a_0*h_a + k_a*turn_a_0
    nu_u_dot_1 = nu_e_1 + bend_a_1*h_a + k_a*turn_a_1
    nu_u_dot_2 = nu_e_2 + bend_a_2*h_a + k_a*turn_a_2
    nu_u_dot_3 = nu_e_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a
    nu_u_dot_4 = nu_e_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a
    nu_u_dot_5 = nu_e_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a
    nu_u_dot_6 = nu_e_6 + bend_b_0*h_raw_b + reach_b*turn_b_0
    nu_u_dot_7 = nu_e_7 + bend_b_1*h_raw_b + reach_b*turn_b_1
    nu_u_dot_8 = nu_e_8 + bend_b_2*h_raw_b + reach_b*turn_b_2
    # drive: lambda nu_u [rad/s, m/s]
    drive_0 = phi_a_0*rate_gain
    drive_1 = phi_a_1*rate_gain
    drive_2 = phi_a_2*rate_gain
    drive_3 = rate_gain*rho_p_a_0
    drive_4 = rate_gain*rho_p_a_1
    drive_5 = rate_gain*rho_p_a_2
    drive_6 = nu_u_6*rate_gain
    drive_7 = nu_u_7*rate_gain
    drive_8 = nu_u_8*rate_gain
    # s: sliding variable [rad/s, m/s], eq. (SurfaceErr)
    s_0 = drive_0 + nu_e_0
    s_1 = drive_1 + nu_e_1
    s_2 = drive_2 + nu_e_2
    s_3 = drive_3 + nu_e_3
    s_4 = drive_4 + nu_e_4
    s_5 = drive_5 + nu_e_5
    s_6 = drive_6 + nu_e_6
    s_7 = drive_7 + nu_e_7
    s_8 = drive_8 + nu_e_8
    # wanted: acceleration asked for [rad/s^2, m/s^2]
    wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0
    wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1
    wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2
    wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3
    wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4
    wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5
    wanted_6 = eta_dot_6 - nu_u_dot_6*rate_gain - reach_gain*s_6
    wanted_7 = eta_dot_7 - nu_u_dot_7*rate_gain - reach_gain*s_7
    wanted_8 = eta_dot_8 - nu_u_dot_8*rate_gain - reach_gain*s_8
    # turning: lambda nu_u - eta, as s - nu [rad/s, m/s]
    turning_0 = s_0 - nu_0
    turning_1 = s_1 - nu_1
    turning_2 = s_2 - nu_2
    turning_3 = s_3 - nu_3
    turning_4 = s_4 - nu_4
    turning_5 = s_5 - nu_5
    turning_6 = s_6 - nu_6
    turning_7 = s_7 - nu_7
    turning_8 = s_8 - nu_8
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4
    momentum_1 = inertia_11*nu_3 + inertia_9*nu_1
    momentum_2 = inertia_17*nu_2 + inertia_2*nu_0
    momentum_3 = inertia_11*nu_1 + inertia_24*nu_3
    momentum_4 = inertia_30*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_35*nu_5
    momentum_6 = inertia_39*nu_6
    momentum_7 = inertia_42*nu_7
    momentum_8 = inertia_44*nu_8
    # force: control force, I f_u [N m, N], eq. (TckCtrl)
    force_0 = (
        inertia_0*wanted_0 + inertia_2*wanted_2 + inertia_4*wanted_4 + momentum_1*turning_2 +
        momentum_4*turning_5 - momentum_2*turning_1 - momentum_5*turning_4
    )
    force_1 = (
        inertia_11*wanted_3 + inertia_9*wanted_1 + momentum_2*turning_0 + momentum_5*turning_3 -
        momentum_0*turning_2 - momentum_3*turning_5
    )
    force_2 = (
        inertia_17*wanted_2 + inertia_2*wanted_0 + momentum_0*turning_1 + momentum_3*turning_4 -
        momentum_1*turning_0 - momentum_4*turning_3
    )
    force_3 = (
        inertia_11*wanted_1 + inertia_24*wanted_3 + momentum_4*turning_2 - momentum_5*turning_1
    )
    force_4 = inertia_30*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 - momentum_3*turning_2
    force_5 = inertia_35*wanted_5 + momentum_3*turning_1 - momentum_4*turning_0
    force_6 = inertia_39*wanted_6 + momentum_7*turning_8 - momentum_8*turning_7
    force_7 = inertia_42*wanted_7 + momentum_8*turning_6 - momentum_6*turning_8
    force_8 = inertia_44*wanted_8 + momentum_6*turning_7 - momentum_7*turning_6
    # -- end --
    return (
        (force_0, force_1, force_2, force_3, force_4, force_5, force_6, force_7, force_8),
        (s_0, s_1, s_2, s_3, s_4, s_5, s_6, s_7, s_8),
        (phi_a_0, phi_a_1, phi_a_2, rho_p_a_0, rho_p_a_1, rho_p_a_2, nu_u_6, nu_u_7, nu_u_8),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2, nu_u_dot_3, nu_u_dot_4, nu_u_dot_5, nu_u_dot_6,
         nu_u_dot_7, nu_u_dot_8),
        (clearance_0,),
    )


def _reaching(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array,
) -> Array:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2)."""
    # -- reaching --
    (
        inertia_0, inertia_2, inertia_4, inertia_9, inertia_11, inertia_17, inertia_24, inertia_30,
        inertia_35, inertia_39, inertia_42, inertia_44,
    ) = (
        inertia[0], inertia[2], inertia[4], inertia[9], inertia[11], inertia[17], inertia[24],
        inertia[30], inertia[35], inertia[39], inertia[42], inertia[44]
    )
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    (
        g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11, g_16, g_17, g_18, g_19, g_20,
        g_21, g_22, g_23, g_24,
    ) = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11], g[16], g[17],
        g[18], g[19], g[20], g[21], g[22], g[23], g[24]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5, nu_6, nu_7, nu_8 = (
        nu[0], nu[1], nu[2], nu[3], nu[4], nu[5], nu[6], nu[7], nu[8]
    )
    # pairs_a: what B's diagonal is made of [1]
    pairs_a_0 = 1.0 + g_0
    pairs_a_1 = 1.0 - g_0
    pairs_a_2 = g_10 + g_5
    pairs_a_3 = g_5 - g_10
    # B_a: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_a_0 = pairs_a_0 - pairs_a_2
    B_a_1 = g_1 + g_4
    B_a_2 = g_2 + g_8
    B_a_3 = g_9 - g_6
    B_a_4 = pairs_a_1 + pairs_a_3
    B_a_5 = g_6 + g_9
    B_a_6 = g_2 - g_8
    B_a_7 = pairs_a_1 - pairs_a_3
    B_a_8 = g_4 - g_1
    B_a_9 = pairs_a_0 + pairs_a_2
    # column_a: a column of B that cannot vanish [1]
    column_a_if_0 = B_a_9.real >= 1.0
    column_a_if_1 = (B_a_0.real >= B_a_4.real) & (B_a_0.real >= B_a_7.real)
    column_a_if_2 = B_a_4.real >= B_a_7.real
    column_a_0 = (
        np.where(column_a_if_0, B_a_3, np.where(column_a_if_1, B_a_0, np.where(column_a_if_2, B_a_1,
        B_a_2)))
    )
    column_a_1 = (
        np.where(column_a_if_0, B_a_6, np.where(column_a_if_1, B_a_1, np.where(column_a_if_2, B_a_4,
        B_a_5)))
    )
    column_a_2 = (
        np.where(column_a_if_0, B_a_8, np.where(column_a_if_1, B_a_2, np.where(column_a_if_2, B_a_5,
        B_a_7)))
    )
    column_a_3 = (
        np.where(column_a_if_0, B_a_9, np.where(column_a_if_1, B_a_3, np.where(column_a_if_2, B_a_6,
        B_a_8)))
    )
    # power_a: the column after one power step [1]
    power_a_0 = B_a_0*column_a_0 + B_a_1*column_a_1 + B_a_2*column_a_2 + B_a_3*column_a_3
    power_a_1 = B_a_1*column_a_0 + B_a_4*column_a_1 + B_a_5*column_a_2 + B_a_6*column_a_3
    power_a_2 = B_a_2*column_a_0 + B_a_5*column_a_1 + B_a_7*column_a_2 + B_a_8*column_a_3
    power_a_3 = B_a_3*column_a_0 + B_a_6*column_a_1 + B_a_8*column_a_2 + B_a_9*column_a_3
    # square_a: square of its vector part [1]
    square_a = power_a_0*power_a_0 + power_a_1*power_a_1 + power_a_2*power_a_2
    # norm_square_a: its squared length [1]
    norm_square_a = square_a + power_a_3*power_a_3
    # norm_bounded_a: the same: less is no element [1]
    norm_bounded_a_if_0 = norm_square_a.real < 49.0
    norm_bounded_a = np.where(norm_bounded_a_if_0, 49.0, norm_square_a)
    # norm_a: its length [1]
    norm_a = np.sqrt(norm_bounded_a)
    # inverse_norm_a: to unit length [1]
    inverse_norm_a = 1.0/norm_a
    # scale_a: to unit length, and to w >= 0: the shorter way round [1]
    scale_a_if_0 = power_a_3.real < 0.0
    scale_a = np.where(scale_a_if_0, -inverse_norm_a, inverse_norm_a)
    # cosine_a: cos of half the error angle, rounded [1]
    cosine_a = power_a_3*scale_a
    # w_a: cos of half the error angle [1]
    w_a_if_0 = cosine_a.real > 1.0
    w_a = np.where(w_a_if_0, 1.0, cosine_a)
    # v_a: sin of half the error angle times its axis [1]
    v_a_0 = power_a_0*scale_a
    v_a_1 = power_a_1*scale_a
    v_a_2 = power_a_2*scale_a
    # k_a: half angle over its sine [1]
    k_a = _k(w_a)
    # h_a: -dk/dw [1]
    h_a = _h(w_a)
    # phi_a: rotation vector of the error [rad]
    phi_a_0 = 2.0*k_a*v_a_0
    phi_a_1 = 2.0*k_a*v_a_1
    phi_a_2 = 2.0*k_a*v_a_2
    # half_a: 1/(2 k) [1]
    half_a = 0.5/k_a
    # swing_p_a: Y p [m]
    swing_p_a_0 = g_11*v_a_1 - g_7*v_a_2
    swing_p_a_1 = g_3*v_a_2 - g_11*v_a_0
    swing_p_a_2 = g_7*v_a_0 - g_3*v_a_1
    # sway_p_a: Y Y p [m]
    sway_p_a_0 = swing_p_a_2*v_a_1 - swing_p_a_1*v_a_2
    sway_p_a_1 = swing_p_a_0*v_a_2 - swing_p_a_2*v_a_0
    sway_p_a_2 = swing_p_a_1*v_a_0 - swing_p_a_0*v_a_1
    # rho_p_a: p - k Y p + h Y Y p [m]
    rho_p_a_0 = g_3 + h_a*sway_p_a_0 - k_a*swing_p_a_0
    rho_p_a_1 = g_7 + h_a*sway_p_a_1 - k_a*swing_p_a_1
    rho_p_a_2 = g_11 + h_a*sway_p_a_2 - k_a*swing_p_a_2
    # y_p_a: rho/(2 k) [m]
    y_p_a_0 = half_a*rho_p_a_0
    y_p_a_1 = half_a*rho_p_a_1
    y_p_a_2 = half_a*rho_p_a_2
    # pairs_b: what B's diagonal is made of [1]
    pairs_b_0 = 1.0 + g_16
    pairs_b_1 = 1.0 - g_16
    pairs_b_2 = g_20 + g_24
    pairs_b_3 = g_20 - g_24
    # B_b: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_b_0 = pairs_b_0 - pairs_b_2
    B_b_1 = g_17 + g_19
    B_b_2 = g_18 + g_22
    B_b_3 = g_23 - g_21
    B_b_4 = pairs_b_1 + pairs_b_3
    B_b_5 = g_21 + g_23
    B_b_6 = g_18 - g_22
    B_b_7 = pairs_b_1 - pairs_b_3
    B_b_8 = g_19 - g_17
    B_b_9 = pairs_b_0 + pairs_b_2
    # column_b: a column of B that cannot vanish [1]
    column_b_if_0 = B_b_9.real >= 1.0
    column_b_if_1 = (B_b_0.real >= B_b_4.real) & (B_b_0.real >= B_b_7.real)
    column_b_if_2 = B_b_4.real >= B_b_7.real
    column_b_0 = (
        np.where(column_b_if_0, B_b_3, np.where(column_b_if_1, B_b_0, np.where(column_b_if_2, B_b_1,
        B_b_2)))
    )
    column_b_1 = (
        np.where(column_b_if_0, B_b_6, np.where(column_b_if_1, B_b_1, np.where(column_b_if_2, B_b_4,
        B_b_5)))
    )
    column_b_2 = (
        np.where(column_b_if_0, B_b_8, np.where(column_b_if_1, B_b_2, np.where(column_b_if_2, B_b_5,
        B_b_7)))
    )
    column_b_3 = (
        np.where(column_b_if_0, B_b_9, np.where(column_b_if_1, B_b_3, np.where(column_b_if_2, B_b_6,
        B_b_8)))
    )
    # power_b: the column after one power step [1]
    power_b_0 = B_b_0*column_b_0 + B_b_1*column_b_1 + B_b_2*column_b_2 + B_b_3*column_b_3
    power_b_1 = B_b_1*column_b_0 + B_b_4*column_b_1 + B_b_5*column_b_2 + B_b_6*column_b_3
    power_b_2 = B_b_2*column_b_0 + B_b_5*column_b_1 + B_b_7*column_b_2 + B_b_8*column_b_3
    power_b_3 = B_b_3*column_b_0 + B_b_6*column_b_1 + B_b_8*column_b_2 + B_b_9*column_b_3
    # square_b: square of its vector part [1]
    square_b = power_b_0*power_b_0 + power_b_1*power_b_1 + power_b_2*power_b_2
    # norm_square_b: its squared length [1]
    norm_square_b = square_b + power_b_3*power_b_3
    # norm_bounded_b: the same: less is no element [1]
    norm_bounded_b_if_0 = norm_square_b.real < 49.0
    norm_bounded_b = np.where(norm_bounded_b_if_0, 49.0, norm_square_b)
    # norm_b: its length [1]
    norm_b = np.sqrt(norm_bounded_b)
    # inverse_norm_b: to unit length [1]
    inverse_norm_b = 1.0/norm_b
    # scale_b: to unit length, and to w >= 0: the shorter way round [1]
    scale_b_if_0 = power_b_3.real < 0.0
    scale_b = np.where(scale_b_if_0, -inverse_norm_b, inverse_norm_b)
    # w_b: cos of half the error angle [1]
    w_b = power_b_3*scale_b
    # k_b: half angle over its sine [1]
    k_b = _k(w_b)
    # h_raw_b: -dk/dw by the scale's square, as s^2 h = 1 - w k [1]
    h_raw_b = (1.0 - k_b*w_b)/(square_b + 1.0e-17)
    # reach_b: p by the scale, but for a number [1]
    reach_b = k_b*scale_b
    # stretch_b: ratio of nu_u to the vector part [1]
    stretch_b = 2.0*reach_b
    # nu_u: kinematic law, the logarithm and the rotation vector [rad, m], def. (KctrLaw)
    nu_u_6 = power_b_0*stretch_b
    nu_u_7 = power_b_1*stretch_b
    nu_u_8 = power_b_2*stretch_b
    # turn_a: Y nu_e, Y = ad of y [rad/s, m/s]
    turn_a_0 = nu_2*v_a_1 - nu_1*v_a_2
    turn_a_1 = nu_0*v_a_2 - nu_2*v_a_0
    turn_a_2 = nu_1*v_a_0 - nu_0*v_a_1
    turn_a_3 = nu_2*y_p_a_1 + nu_5*v_a_1 - nu_1*y_p_a_2 - nu_4*v_a_2
    turn_a_4 = nu_0*y_p_a_2 + nu_3*v_a_2 - nu_2*y_p_a_0 - nu_5*v_a_0
    turn_a_5 = nu_1*y_p_a_0 + nu_4*v_a_0 - nu_0*y_p_a_1 - nu_3*v_a_1
    # bend_a: Y Y nu_e [rad/s, m/s]
    bend_a_0 = turn_a_2*v_a_1 - turn_a_1*v_a_2
    bend_a_1 = turn_a_0*v_a_2 - turn_a_2*v_a_0
    bend_a_2 = turn_a_1*v_a_0 - turn_a_0*v_a_1
    bend_a_3 = turn_a_2*y_p_a_1 + turn_a_5*v_a_1 - turn_a_1*y_p_a_2 - turn_a_4*v_a_2
    bend_a_4 = turn_a_0*y_p_a_2 + turn_a_3*v_a_2 - turn_a_2*y_p_a_0 - turn_a_5*v_a_0
    bend_a_5 = turn_a_1*y_p_a_0 + turn_a_4*v_a_0 - turn_a_0*y_p_a_1 - turn_a_3*v_a_1
    # m_a: -dh/dw [1]
    m_a = _m(w_a)
    # along_p_a: -2 v.q [m]
    along_p_a = -2.0*(v_a_0*y_p_a_0 + v_a_1*y_p_a_1 + v_a_2*y_p_a_2)
    # tail_a: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s]
    tail_a_3 = along_p_a*bend_a_0
    tail_a_4 = along_p_a*bend_a_1
    tail_a_5 = along_p_a*bend_a_2
    # twofold_a: h^2 - k m/2, of the double root [1]
    twofold_a = h_a*h_a - 0.5*k_a*m_a
    # turn_b: vector part x nu_e, its share [rad/s]
    turn_b_0 = nu_8*power_b_1 - nu_7*power_b_2
    turn_b_1 = nu_6*power_b_2 - nu_8*power_b_0
    turn_b_2 = nu_7*power_b_0 - nu_6*power_b_1
    # bend_b: vector part x that [rad/s]
    bend_b_0 = power_b_1*turn_b_2 - power_b_2*turn_b_1
    bend_b_1 = power_b_2*turn_b_0 - power_b_0*turn_b_2
    bend_b_2 = power_b_0*turn_b_1 - power_b_1*turn_b_0
    # nu_u_dot: exact rate of nu_u [rad/s, m/s]
    nu_u_dot_0 = nu_0 + bend_a_0*h_a + k_a*turn_a_0
    nu_u_dot_1 = nu_1 + bend_a_1*h_a + k_a*turn_a_1
    nu_u_dot_2 = nu_2 + bend_a_2*h_a + k_a*turn_a_2
    nu_u_dot_3 = nu_3 + bend_a_3*h_a + k_a*turn_a_3 + tail_a_3*twofold_a
    nu_u_dot_4 = nu_4 + bend_a_4*h_a + k_a*turn_a_4 + tail_a_4*twofold_a
    nu_u_dot_5 = nu_5 + bend_a_5*h_a + k_a*turn_a_5 + tail_a_5*twofold_a
    nu_u_dot_6 = nu_6 + bend_b_0*h_raw_b + reach_b*turn_b_0
    nu_u_dot_7 = nu_7 + bend_b_1*h_raw_b + reach_b*turn_b_1
    nu_u_dot_8 = nu_8 + bend_b_2*h_raw_b + reach_b*turn_b_2
    # drive: lambda nu_u [rad/s, m/s]
    drive_0 = phi_a_0*rate_gain
    drive_1 = phi_a_1*rate_gain
    drive_2 = phi_a_2*rate_gain
    drive_3 = rate_gain*rho_p_a_0
    drive_4 = rate_gain*rho_p_a_1
    drive_5 = rate_gain*rho_p_a_2
    drive_6 = nu_u_6*rate_gain
    drive_7 = nu_u_7*rate_gain
    drive_8 = nu_u_8*rate_gain
    # s: sliding variable [rad/s, m/s], eq. (sldS)
    s_0 = drive_0 + nu_0
    s_1 = drive_1 + nu_1
    s_2 = drive_2 + nu_2
    s_3 = drive_3 + nu_3
    s_4 = drive_4 + nu_4
    s_5 = drive_5 + nu_5
    s_6 = drive_6 + nu_6
    s_7 = drive_7 + nu_7
    s_8 = drive_8 + nu_8
    # wanted: acceleration asked for [rad/s^2, m/s^2]
    wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0)
    wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1)
    wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2)
    wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3)
    wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4)
    wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5)
    wanted_6 = -(nu_u_dot_6*rate_gain + reach_gain*s_6)
    wanted_7 = -(nu_u_dot_7*rate_gain + reach_gain*s_7)
    wanted_8 = -(nu_u_dot_8*rate_gain + reach_gain*s_8)
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4
    momentum_1 = inertia_11*nu_3 + inertia_9*nu_1
    momentum_2 = inertia_17*nu_2 + inertia_2*nu_0
    momentum_3 = inertia_11*nu_1 + inertia_24*nu_3
    momentum_4 = inertia_30*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_35*nu_5
    momentum_6 = inertia_39*nu_6
    momentum_7 = inertia_42*nu_7
    momentum_8 = inertia_44*nu_8
    # force: control force, I f_u [N m, N], eq. (Ctrl2)
    force_0 = (
        drive_2*momentum_1 + drive_5*momentum_4 + inertia_0*wanted_0 + inertia_2*wanted_2 +
        inertia_4*wanted_4 - drive_1*momentum_2 - drive_4*momentum_5
    )
    force_1 = (
        drive_0*momentum_2 + drive_3*momentum_5 + inertia_11*wanted_3 + inertia_9*wanted_1 -
        drive_2*momentum_0 - drive_5*momentum_3
    )
    force_2 = (
        drive_1*momentum_0 + drive_4*momentum_3 + inertia_17*wanted_2 + inertia_2*wanted_0 -
        drive_0*momentum_1 - drive_3*momentum_4
    )
    force_3 = drive_2*momentum_4 + inertia_11*wanted_1 + inertia_24*wanted_3 - drive_1*momentum_5
    force_4 = drive_0*momentum_5 + inertia_30*wanted_4 + inertia_4*wanted_0 - drive_2*momentum_3
    force_5 = drive_1*momentum_3 + inertia_35*wanted_5 - drive_0*momentum_4
    force_6 = drive_8*momentum_7 + inertia_39*wanted_6 - drive_7*momentum_8
    force_7 = drive_6*momentum_8 + inertia_42*wanted_7 - drive_8*momentum_6
    force_8 = drive_7*momentum_6 + inertia_44*wanted_8 - drive_6*momentum_7
    # -- end --
    return (
        (force_0, force_1, force_2, force_3, force_4, force_5, force_6, force_7, force_8),
        (s_0, s_1, s_2, s_3, s_4, s_5, s_6, s_7, s_8),
        (phi_a_0, phi_a_1, phi_a_2, rho_p_a_0, rho_p_a_1, rho_p_a_2, nu_u_6, nu_u_7, nu_u_8),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2, nu_u_dot_3, nu_u_dot_4, nu_u_dot_5, nu_u_dot_6,
         nu_u_dot_7, nu_u_dot_8),
    )


def _plant(
    inertia: Array, nu: Array, force: Array,
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP)."""
    # -- plant --
    (
        inertia_0, inertia_2, inertia_4, inertia_9, inertia_11, inertia_17, inertia_24, inertia_30,
        inertia_35, inertia_39, inertia_42, inertia_44,
    ) = (
        inertia[0], inertia[2], inertia[4], inertia[9], inertia[11], inertia[17], inertia[24],
        inertia[30], inertia[35], inertia[39], inertia[42], inertia[44]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5, nu_6, nu_7, nu_8 = (
        nu[0], nu[1], nu[2], nu[3], nu[4], nu[5], nu[6], nu[7], nu[8]
    )
    force_0, force_1, force_2, force_3, force_4, force_5, force_6, force_7, force_8 = (
        force[0], force[1], force[2], force[3], force[4], force[5], force[6], force[7], force[8]
    )
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_2*nu_2 + inertia_4*nu_4
    momentum_1 = inertia_11*nu_3 + inertia_9*nu_1
    momentum_2 = inertia_17*nu_2 + inertia_2*nu_0
    momentum_3 = inertia_11*nu_1 + inertia_24*nu_3
    momentum_4 = inertia_30*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_35*nu_5
    momentum_6 = inertia_39*nu_6
    momentum_7 = inertia_42*nu_7
    momentum_8 = inertia_44*nu_8
    # total: coad(nu) I nu + force [N m, N]
    total_0 = force_0 + momentum_1*nu_2 + momentum_4*nu_5 - momentum_2*nu_1 - momentum_5*nu_4
    total_1 = force_1 + momentum_2*nu_0 + momentum_5*nu_3 - momentum_0*nu_2 - momentum_3*nu_5
    total_2 = force_2 + momentum_0*nu_1 + momentum_3*nu_4 - momentum_1*nu_0 - momentum_4*nu_3
    total_3 = force_3 + momentum_4*nu_2 - momentum_5*nu_1
    total_4 = force_4 + momentum_5*nu_0 - momentum_3*nu_2
    total_5 = force_5 + momentum_3*nu_1 - momentum_4*nu_0
    total_6 = force_6 + momentum_7*nu_8 - momentum_8*nu_7
    total_7 = force_7 + momentum_8*nu_6 - momentum_6*nu_8
    total_8 = force_8 + momentum_6*nu_7 - momentum_7*nu_6
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/inertia_0
    # lower_40: I = L D L^T, entry of L [1]
    lower_40 = inertia_4/inertia_0
    # lower_31: I = L D L^T, entry of L [1]
    lower_31 = inertia_11/inertia_9
    # pivot_2: pivot of I [kg m^2, kg m, kg]
    pivot_2 = inertia_17 - inertia_0*lower_20*lower_20
    # lower_42: I = L D L^T, entry of L [1]
    lower_42 = -inertia_0*lower_20*lower_40/pivot_2
    # pivot_3: pivot of I [kg m^2, kg m, kg]
    pivot_3 = inertia_24 - inertia_9*lower_31*lower_31
    # pivot_4: pivot of I [kg m^2, kg m, kg]
    pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42
    # forward_2: forward substitution [N m, N]
    forward_2 = total_2 - lower_20*total_0
    # forward_3: forward substitution [N m, N]
    forward_3 = total_3 - lower_31*total_1
    # forward_4: forward substitution [N m, N]
    forward_4 = total_4 - forward_2*lower_42 - lower_40*total_0
    # back_8: back substitution [rad/s^2, m/s^2]
    back_8 = total_8/inertia_44
    # back_7: back substitution [rad/s^2, m/s^2]
    back_7 = total_7/inertia_42
    # back_6: back substitution [rad/s^2, m/s^2]
    back_6 = total_6/inertia_39
    # back_5: back substitution [rad/s^2, m/s^2]
    back_5 = total_5/inertia_35
    # back_4: back substitution [rad/s^2, m/s^2]
    back_4 = forward_4/pivot_4
    # back_3: back substitution [rad/s^2, m/s^2]
    back_3 = forward_3/pivot_3
    # back_2: back substitution [rad/s^2, m/s^2]
    back_2 = forward_2/pivot_2 - back_4*lower_42
    # back_1: back substitution [rad/s^2, m/s^2]
    back_1 = total_1/inertia_9 - back_3*lower_31
    # back_0: back substitution [rad/s^2, m/s^2]
    back_0 = total_0/inertia_0 - back_2*lower_20 - back_4*lower_40
    # -- end --
    return (
        (back_0, back_1, back_2, back_3, back_4, back_5, back_6, back_7, back_8),
    )


def _definiteness(
    inertia: Array,
) -> Array:
    """Pivots of the inertia: all positive for a valid one."""
    # -- definiteness --
    (
        inertia_0, inertia_2, inertia_4, inertia_9, inertia_11, inertia_17, inertia_24, inertia_30,
        inertia_35, inertia_39, inertia_42, inertia_44,
    ) = (
        inertia[0], inertia[2], inertia[4], inertia[9], inertia[11], inertia[17], inertia[24],
        inertia[30], inertia[35], inertia[39], inertia[42], inertia[44]
    )
    # divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_0_if_0 = inertia_0.real > 0.0
    divisor_0 = np.where(divisor_0_if_0, inertia_0, 1.0)
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/divisor_0
    # lower_40: I = L D L^T, entry of L [1]
    lower_40 = inertia_4/divisor_0
    # divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_1_if_0 = inertia_9.real > 0.0
    divisor_1 = np.where(divisor_1_if_0, inertia_9, 1.0)
    # lower_31: I = L D L^T, entry of L [1]
    lower_31 = inertia_11/divisor_1
    # pivot_2: pivot of I [kg m^2, kg m, kg]
    pivot_2 = inertia_17 - inertia_0*lower_20*lower_20
    # divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_2_if_0 = pivot_2.real > 0.0
    divisor_2 = np.where(divisor_2_if_0, pivot_2, 1.0)
    # lower_42: I = L D L^T, entry of L [1]
    lower_42 = -inertia_0*lower_20*lower_40/divisor_2
    # pivot_3: pivot of I [kg m^2, kg m, kg]
    pivot_3 = inertia_24 - inertia_9*lower_31*lower_31
    # pivot_4: pivot of I [kg m^2, kg m, kg]
    pivot_4 = inertia_30 - inertia_0*lower_40*lower_40 - pivot_2*lower_42*lower_42
    # -- end --
    return (
        (inertia_0, inertia_9, pivot_2, pivot_3, pivot_4, inertia_35, inertia_39, inertia_42,
         inertia_44),
    )


def _error(
    g: Array, g_r: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    (
        g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11, g_16, g_17, g_18, g_19, g_20,
        g_21, g_22, g_23, g_24,
    ) = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11], g[16], g[17],
        g[18], g[19], g[20], g[21], g[22], g[23], g[24]
    )
    (
        g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8, g_r_9, g_r_10, g_r_11,
        g_r_16, g_r_17, g_r_18, g_r_19, g_r_20, g_r_21, g_r_22, g_r_23, g_r_24,
    ) = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8], g_r[9], g_r[10],
        g_r[11], g_r[16], g_r[17], g_r[18], g_r[19], g_r[20], g_r[21], g_r[22], g_r[23], g_r[24]
    )
    # gap_0_a: translation of g from g_r [m]
    gap_0_a_0 = g_3 - g_r_3
    gap_0_a_1 = g_7 - g_r_7
    gap_0_a_2 = g_11 - g_r_11
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8
    g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8
    g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4
    g_e_3 = g_r_0*gap_0_a_0 + g_r_4*gap_0_a_1 + g_r_8*gap_0_a_2
    g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9
    g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9
    g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5
    g_e_7 = g_r_1*gap_0_a_0 + g_r_5*gap_0_a_1 + g_r_9*gap_0_a_2
    g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10
    g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10
    g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6
    g_e_11 = g_r_10*gap_0_a_2 + g_r_2*gap_0_a_0 + g_r_6*gap_0_a_1
    g_e_16 = g_16*g_r_16 + g_19*g_r_19 + g_22*g_r_22
    g_e_17 = g_17*g_r_16 + g_20*g_r_19 + g_23*g_r_22
    g_e_18 = g_18*g_r_16 + g_21*g_r_19 + g_24*g_r_22
    g_e_19 = g_16*g_r_17 + g_19*g_r_20 + g_22*g_r_23
    g_e_20 = g_17*g_r_17 + g_20*g_r_20 + g_23*g_r_23
    g_e_21 = g_18*g_r_17 + g_21*g_r_20 + g_24*g_r_23
    g_e_22 = g_16*g_r_18 + g_19*g_r_21 + g_22*g_r_24
    g_e_23 = g_17*g_r_18 + g_20*g_r_21 + g_23*g_r_24
    g_e_24 = g_18*g_r_18 + g_21*g_r_21 + g_24*g_r_24
    # -- end --
    return (
        (g_e_0, g_e_1, g_e_2, g_e_3, g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, 0.0,
         0.0, 0.0, 1.0, g_e_16, g_e_17, g_e_18, g_e_19, g_e_20, g_e_21, g_e_22, g_e_23, g_e_24),
    )


def _drift(
    g_e: Array, g: Array, g_r: Array,
) -> Array:
    """Square of the distance from the group."""
    # -- drift --
    (
        g_e_0, g_e_1, g_e_2, g_e_4, g_e_5, g_e_6, g_e_8, g_e_9, g_e_10, g_e_16, g_e_17, g_e_18,
        g_e_19, g_e_20, g_e_21, g_e_22, g_e_23, g_e_24,
    ) = (
        g_e[0], g_e[1], g_e[2], g_e[4], g_e[5], g_e[6], g_e[8], g_e[9], g_e[10], g_e[16], g_e[17],
        g_e[18], g_e[19], g_e[20], g_e[21], g_e[22], g_e[23], g_e[24]
    )
    g_12, g_13, g_14, g_15 = g[12], g[13], g[14], g[15]
    g_r_12, g_r_13, g_r_14, g_r_15 = g_r[12], g_r[13], g_r[14], g_r[15]
    # off: what vanishes on the group, and only there [1]
    off_0 = g_e_0*g_e_0 - 1.0 + g_e_4*g_e_4 + g_e_8*g_e_8
    off_1 = g_e_0*g_e_1 + g_e_4*g_e_5 + g_e_8*g_e_9
    off_2 = g_e_1*g_e_1 - 1.0 + g_e_5*g_e_5 + g_e_9*g_e_9
    off_3 = g_e_2 + g_e_5*g_e_8 - g_e_4*g_e_9
    off_4 = g_e_6 + g_e_0*g_e_9 - g_e_1*g_e_8
    off_5 = g_e_10 + g_e_1*g_e_4 - g_e_0*g_e_5
    off_6 = g_e_16*g_e_16 - 1.0 + g_e_19*g_e_19 + g_e_22*g_e_22
    off_7 = g_e_16*g_e_17 + g_e_19*g_e_20 + g_e_22*g_e_23
    off_8 = g_e_17*g_e_17 - 1.0 + g_e_20*g_e_20 + g_e_23*g_e_23
    off_9 = g_e_18 + g_e_20*g_e_22 - g_e_19*g_e_23
    off_10 = g_e_21 + g_e_16*g_e_23 - g_e_17*g_e_22
    off_11 = g_e_24 + g_e_17*g_e_19 - g_e_16*g_e_20
    off_15 = g_15 - 1.0
    off_19 = g_r_15 - 1.0
    # drift: square of the distance from the group [1]
    drift = (
        g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 + g_r_14*g_r_14 +
        off_0*off_0 + off_1*off_1 + off_10*off_10 + off_11*off_11 + off_15*off_15 + off_19*off_19 +
        off_2*off_2 + off_3*off_3 + off_4*off_4 + off_5*off_5 + off_6*off_6 + off_7*off_7 +
        off_8*off_8 + off_9*off_9
    )
    # -- end --
    return (
        (drift,),
    )
