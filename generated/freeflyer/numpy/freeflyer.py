"""freeflyer: gsmc on SE3, law {'name': 'tracking', 'doc': 'force that drives (g, nu) to (g_r,
nu_r)', 'source': 'eq. (TckCtrl)', 'inputs': [{'name': 'inertia', 'size': 21, 'unit': 'kg m^2, kg m,
kg', 'doc': 'inertia, upper triangle, row by row', 'source': '', 'is_scalar': False, 'holder':
'params', 'member': 'inertia', 'entries': [['inertia_0', 0], ['inertia_1', 1], ['inertia_2', 2],
['inertia_4', 4], ['inertia_5', 5], ['inertia_6', 6], ['inertia_7', 7], ['inertia_8', 8],
['inertia_10', 10], ['inertia_11', 11], ['inertia_12', 12], ['inertia_13', 13], ['inertia_15', 15],
['inertia_18', 18], ['inertia_20', 20]], 'argument': 'inertia', 'shape': (21,)}, {'name':
'rate_gain', 'size': 1, 'unit': '1/s', 'doc': 'sliding rate', 'source': '', 'is_scalar': True,
'holder': 'params', 'member': 'lambda', 'entries': [['rate_gain', 0]], 'argument': 'lambda_',
'shape': (1,)}, {'name': 'reach_gain', 'size': 1, 'unit': '1/s', 'doc': 'reaching rate', 'source':
'', 'is_scalar': True, 'holder': 'params', 'member': 'k_s', 'entries': [['reach_gain', 0]],
'argument': 'k_s', 'shape': (1,)}, {'name': 'nu', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'body
velocity', 'source': '', 'is_scalar': False, 'holder': 'state', 'member': 'nu', 'entries': [['nu_0',
0], ['nu_1', 1], ['nu_2', 2], ['nu_3', 3], ['nu_4', 4], ['nu_5', 5]], 'argument': 'nu', 'shape':
(6,)}, {'name': 'nu_r', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'reference velocity, reference body
frame', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu', 'entries':
[['nu_r_0', 0], ['nu_r_1', 1], ['nu_r_2', 2], ['nu_r_3', 3], ['nu_r_4', 4], ['nu_r_5', 5]],
'argument': 'nu_r', 'shape': (6,)}, {'name': 'nu_r_dot', 'size': 6, 'unit': 'rad/s^2, m/s^2', 'doc':
'its rate', 'source': '', 'is_scalar': False, 'holder': 'reference', 'member': 'nu_dot', 'entries':
[['nu_r_dot_0', 0], ['nu_r_dot_1', 1], ['nu_r_dot_2', 2], ['nu_r_dot_3', 3], ['nu_r_dot_4', 4],
['nu_r_dot_5', 5]], 'argument': 'nu_r_dot', 'shape': (6,)}, {'name': 'g_e', 'size': 16, 'unit': '1',
'doc': 'error, g_r^-1 g', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member':
'g_e', 'entries': [['g_e_0', 0], ['g_e_1', 1], ['g_e_2', 2], ['g_e_3', 3], ['g_e_4', 4], ['g_e_5',
5], ['g_e_6', 6], ['g_e_7', 7], ['g_e_8', 8], ['g_e_9', 9], ['g_e_10', 10], ['g_e_11', 11]],
'argument': 'g_e', 'shape': (16,)}], 'steps': [{'name': 'eta_arm_0', 'size': 3, 'unit': 'm/s',
'doc': 'velocity at p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['eta_arm_0_0', 'eta_arm_0_1', 'eta_arm_0_2'], 'lines': [['eta_arm_0_0', 'nu_r_3 + g_e_11*nu_r_1 -
g_e_7*nu_r_2'], ['eta_arm_0_1', 'nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0'], ['eta_arm_0_2', 'nu_r_5 +
g_e_7*nu_r_0 - g_e_3*nu_r_1']], 'cases': []}, {'name': 'eta', 'size': 6, 'unit': 'rad/s, m/s',
'doc': 'reference velocity in the body frame', 'source': 'eq. (velErr)', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['eta_0', 'eta_1', 'eta_2', 'eta_3', 'eta_4', 'eta_5'],
'lines': [['eta_0', 'g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2'], ['eta_1', 'g_e_1*nu_r_0 +
g_e_5*nu_r_1 + g_e_9*nu_r_2'], ['eta_2', 'g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1'], ['eta_3',
'eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_4 + eta_arm_0_2*g_e_8'], ['eta_4', 'eta_arm_0_0*g_e_1 +
eta_arm_0_1*g_e_5 + eta_arm_0_2*g_e_9'], ['eta_5', 'eta_arm_0_0*g_e_2 + eta_arm_0_1*g_e_6 +
eta_arm_0_2*g_e_10']], 'cases': []}, {'name': 'nu_e', 'size': 6, 'unit': 'rad/s, m/s', 'doc':
'velocity error', 'source': 'eq. (velErr)', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['nu_e_0', 'nu_e_1', 'nu_e_2', 'nu_e_3', 'nu_e_4', 'nu_e_5'], 'lines': [['nu_e_0', 'nu_0 - eta_0'],
['nu_e_1', 'nu_1 - eta_1'], ['nu_e_2', 'nu_2 - eta_2'], ['nu_e_3', 'nu_3 - eta_3'], ['nu_e_4', 'nu_4
- eta_4'], ['nu_e_5', 'nu_5 - eta_5']], 'cases': []}, {'name': 'eta_dot_arm_0', 'size': 3, 'unit':
'm/s', 'doc': 'velocity at p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '',
'names': ['eta_dot_arm_0_0', 'eta_dot_arm_0_1', 'eta_dot_arm_0_2'], 'lines': [['eta_dot_arm_0_0',
'nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2'], ['eta_dot_arm_0_1', 'nu_r_dot_4 +
g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0'], ['eta_dot_arm_0_2', 'nu_r_dot_5 + g_e_7*nu_r_dot_0 -
g_e_3*nu_r_dot_1']], 'cases': []}, {'name': 'eta_dot', 'size': 6, 'unit': 'rad/s^2, m/s^2', 'doc':
'exact rate of eta', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['eta_dot_0', 'eta_dot_1', 'eta_dot_2', 'eta_dot_3', 'eta_dot_4', 'eta_dot_5'], 'lines':
[['eta_dot_0', 'eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 -
eta_2*nu_e_1'], ['eta_dot_1', 'eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2
- eta_0*nu_e_2'], ['eta_dot_2', 'eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 +
g_e_6*nu_r_dot_1 - eta_1*nu_e_0'], ['eta_dot_3', 'eta_1*nu_e_5 + eta_4*nu_e_2 +
eta_dot_arm_0_0*g_e_0 + eta_dot_arm_0_1*g_e_4 + eta_dot_arm_0_2*g_e_8 - eta_2*nu_e_4 -
eta_5*nu_e_1'], ['eta_dot_4', 'eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_0*g_e_1 +
eta_dot_arm_0_1*g_e_5 + eta_dot_arm_0_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2'], ['eta_dot_5',
'eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_0*g_e_2 + eta_dot_arm_0_1*g_e_6 +
eta_dot_arm_0_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0']], 'cases': []}, {'name': 'pairs', 'size': 4,
'unit': '1', 'doc': "what B's diagonal is made of", 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['pairs_0', 'pairs_1', 'pairs_2', 'pairs_3'], 'lines': [['pairs_0', '1.0 +
g_e_0'], ['pairs_1', '1.0 - g_e_0'], ['pairs_2', 'g_e_10 + g_e_5'], ['pairs_3', 'g_e_5 - g_e_10']],
'cases': []}, {'name': 'B', 'size': 10, 'unit': '1', 'doc': '4 p p^T, p = (v, w), by rows',
'source': 'polar factor of Markley and Bar-Itzhack', 'is_scalar': False, 'holder': '', 'member': '',
'names': ['B_0', 'B_1', 'B_2', 'B_3', 'B_4', 'B_5', 'B_6', 'B_7', 'B_8', 'B_9'], 'lines': [['B_0',
'pairs_0 - pairs_2'], ['B_1', 'g_e_1 + g_e_4'], ['B_2', 'g_e_2 + g_e_8'], ['B_3', 'g_e_9 - g_e_6'],
['B_4', 'pairs_1 + pairs_3'], ['B_5', 'g_e_6 + g_e_9'], ['B_6', 'g_e_2 - g_e_8'], ['B_7', 'pairs_1 -
pairs_3'], ['B_8', 'g_e_4 - g_e_1'], ['B_9', 'pairs_0 + pairs_2']], 'cases': []}, {'name': 'column',
'size': 4, 'unit': '1', 'doc': 'a column of B that cannot vanish', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['column_0', 'column_1', 'column_2', 'column_3'], 'lines': [],
'cases': [{'condition': 'B_9.real >= 1.0', 'lines': [['column_0', 'B_3'], ['column_1', 'B_6'],
['column_2', 'B_8'], ['column_3', 'B_9']]}, {'condition': '(B_0.real >= B_4.real) & (B_0.real >=
B_7.real)', 'lines': [['column_0', 'B_0'], ['column_1', 'B_1'], ['column_2', 'B_2'], ['column_3',
'B_3']]}, {'condition': 'B_4.real >= B_7.real', 'lines': [['column_0', 'B_1'], ['column_1', 'B_4'],
['column_2', 'B_5'], ['column_3', 'B_6']]}, {'condition': '', 'lines': [['column_0', 'B_2'],
['column_1', 'B_5'], ['column_2', 'B_7'], ['column_3', 'B_8']]}]}, {'name': 'power', 'size': 4,
'unit': '1', 'doc': 'the column after one power step', 'source': '', 'is_scalar': False, 'holder':
'', 'member': '', 'names': ['power_0', 'power_1', 'power_2', 'power_3'], 'lines': [['power_0',
'B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3'], ['power_1', 'B_1*column_0 +
B_4*column_1 + B_5*column_2 + B_6*column_3'], ['power_2', 'B_2*column_0 + B_5*column_1 +
B_7*column_2 + B_8*column_3'], ['power_3', 'B_3*column_0 + B_6*column_1 + B_8*column_2 +
B_9*column_3']], 'cases': []}, {'name': 'square', 'size': 1, 'unit': '1', 'doc': 'square of its
vector part', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['square'],
'lines': [['square', 'power_0*power_0 + power_1*power_1 + power_2*power_2']], 'cases': []}, {'name':
'norm_square', 'size': 1, 'unit': '1', 'doc': 'its squared length', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['norm_square'], 'lines': [['norm_square', 'square +
power_3*power_3']], 'cases': []}, {'name': 'norm_bounded', 'size': 1, 'unit': '1', 'doc': 'the same:
less is no element', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names':
['norm_bounded'], 'lines': [], 'cases': [{'condition': 'norm_square.real < 49.0', 'lines':
[['norm_bounded', '49.0']]}, {'condition': '', 'lines': [['norm_bounded', 'norm_square']]}]},
{'name': 'norm', 'size': 1, 'unit': '1', 'doc': 'its length', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['norm'], 'lines': [['norm', 'np.sqrt(norm_bounded)']],
'cases': []}, {'name': 'inverse_norm', 'size': 1, 'unit': '1', 'doc': 'to unit length', 'source':
'', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['inverse_norm'], 'lines':
[['inverse_norm', '1.0/norm']], 'cases': []}, {'name': 'scale', 'size': 1, 'unit': '1', 'doc': 'to
unit length, and to w >= 0: the shorter way round', 'source': '', 'is_scalar': True, 'holder': '',
'member': '', 'names': ['scale'], 'lines': [], 'cases': [{'condition': 'power_3.real < 0.0',
'lines': [['scale', '-inverse_norm']]}, {'condition': '', 'lines': [['scale', 'inverse_norm']]}]},
{'name': 'cosine', 'size': 1, 'unit': '1', 'doc': 'cos of half the error angle, rounded', 'source':
'', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['cosine'], 'lines': [['cosine',
'power_3*scale']], 'cases': []}, {'name': 'w', 'size': 1, 'unit': '1', 'doc': 'cos of half the error
angle', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['w'], 'lines': [],
'cases': [{'condition': 'cosine.real > 1.0', 'lines': [['w', '1.0']]}, {'condition': '', 'lines':
[['w', 'cosine']]}]}, {'name': 'v', 'size': 3, 'unit': '1', 'doc': 'sin of half the error angle
times its axis', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['v_0',
'v_1', 'v_2'], 'lines': [['v_0', 'power_0*scale'], ['v_1', 'power_1*scale'], ['v_2',
'power_2*scale']], 'cases': []}, {'name': 'k', 'size': 1, 'unit': '1', 'doc': 'half angle over its
sine', 'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['k'], 'lines': [['k',
'_k(w)']], 'cases': []}, {'name': 'h', 'size': 1, 'unit': '1', 'doc': '-dk/dw', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['h'], 'lines': [['h', '_h(w)']], 'cases':
[]}, {'name': 'phi', 'size': 3, 'unit': 'rad', 'doc': 'rotation vector of the error', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['phi_0', 'phi_1', 'phi_2'], 'lines':
[['phi_0', '2.0*k*v_0'], ['phi_1', '2.0*k*v_1'], ['phi_2', '2.0*k*v_2']], 'cases': []}, {'name':
'half', 'size': 1, 'unit': '1', 'doc': '1/(2 k)', 'source': '', 'is_scalar': True, 'holder': '',
'member': '', 'names': ['half'], 'lines': [['half', '0.5/k']], 'cases': []}, {'name': 'swing_p',
'size': 3, 'unit': 'm', 'doc': 'Y p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '',
'names': ['swing_p_0', 'swing_p_1', 'swing_p_2'], 'lines': [['swing_p_0', 'g_e_11*v_1 - g_e_7*v_2'],
['swing_p_1', 'g_e_3*v_2 - g_e_11*v_0'], ['swing_p_2', 'g_e_7*v_0 - g_e_3*v_1']], 'cases': []},
{'name': 'sway_p', 'size': 3, 'unit': 'm', 'doc': 'Y Y p', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['sway_p_0', 'sway_p_1', 'sway_p_2'], 'lines': [['sway_p_0',
'swing_p_2*v_1 - swing_p_1*v_2'], ['sway_p_1', 'swing_p_0*v_2 - swing_p_2*v_0'], ['sway_p_2',
'swing_p_1*v_0 - swing_p_0*v_1']], 'cases': []}, {'name': 'rho_p', 'size': 3, 'unit': 'm', 'doc': 'p
- k Y p + h Y Y p', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names':
['rho_p_0', 'rho_p_1', 'rho_p_2'], 'lines': [['rho_p_0', 'g_e_3 + h*sway_p_0 - k*swing_p_0'],
['rho_p_1', 'g_e_7 + h*sway_p_1 - k*swing_p_1'], ['rho_p_2', 'g_e_11 + h*sway_p_2 - k*swing_p_2']],
'cases': []}, {'name': 'y_p', 'size': 3, 'unit': 'm', 'doc': 'rho/(2 k)', 'source': '', 'is_scalar':
False, 'holder': '', 'member': '', 'names': ['y_p_0', 'y_p_1', 'y_p_2'], 'lines': [['y_p_0',
'half*rho_p_0'], ['y_p_1', 'half*rho_p_1'], ['y_p_2', 'half*rho_p_2']], 'cases': []}, {'name':
'turn', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'Y nu_e, Y = ad of y', 'source': '', 'is_scalar':
False, 'holder': '', 'member': '', 'names': ['turn_0', 'turn_1', 'turn_2', 'turn_3', 'turn_4',
'turn_5'], 'lines': [['turn_0', 'nu_e_2*v_1 - nu_e_1*v_2'], ['turn_1', 'nu_e_0*v_2 - nu_e_2*v_0'],
['turn_2', 'nu_e_1*v_0 - nu_e_0*v_1'], ['turn_3', 'nu_e_2*y_p_1 + nu_e_5*v_1 - nu_e_1*y_p_2 -
nu_e_4*v_2'], ['turn_4', 'nu_e_0*y_p_2 + nu_e_3*v_2 - nu_e_2*y_p_0 - nu_e_5*v_0'], ['turn_5',
'nu_e_1*y_p_0 + nu_e_4*v_0 - nu_e_0*y_p_1 - nu_e_3*v_1']], 'cases': []}, {'name': 'bend', 'size': 6,
'unit': 'rad/s, m/s', 'doc': 'Y Y nu_e', 'source': '', 'is_scalar': False, 'holder': '', 'member':
'', 'names': ['bend_0', 'bend_1', 'bend_2', 'bend_3', 'bend_4', 'bend_5'], 'lines': [['bend_0',
'turn_2*v_1 - turn_1*v_2'], ['bend_1', 'turn_0*v_2 - turn_2*v_0'], ['bend_2', 'turn_1*v_0 -
turn_0*v_1'], ['bend_3', 'turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2'], ['bend_4',
'turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0'], ['bend_5', 'turn_1*y_p_0 + turn_4*v_0 -
turn_0*y_p_1 - turn_3*v_1']], 'cases': []}, {'name': 'm', 'size': 1, 'unit': '1', 'doc': '-dh/dw',
'source': '', 'is_scalar': True, 'holder': '', 'member': '', 'names': ['m'], 'lines': [['m',
'_m(w)']], 'cases': []}, {'name': 'along_p', 'size': 1, 'unit': 'm', 'doc': '-2 v.q', 'source': '',
'is_scalar': True, 'holder': '', 'member': '', 'names': ['along_p'], 'lines': [['along_p',
'-2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2)']], 'cases': []}, {'name': 'tail', 'size': 6, 'unit':
'rad/s, m/s', 'doc': '(Y^2 + s^2) Y^2 nu_e', 'source': '', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['tail_3', 'tail_4', 'tail_5'], 'lines': [['tail_3', 'along_p*bend_0'],
['tail_4', 'along_p*bend_1'], ['tail_5', 'along_p*bend_2']], 'cases': []}, {'name': 'twofold',
'size': 1, 'unit': '1', 'doc': 'h^2 - k m/2, of the double root', 'source': '', 'is_scalar': True,
'holder': '', 'member': '', 'names': ['twofold'], 'lines': [['twofold', 'h*h - 0.5*k*m']], 'cases':
[]}, {'name': 'nu_u_dot', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'exact rate of nu_u', 'source':
'', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['nu_u_dot_0', 'nu_u_dot_1',
'nu_u_dot_2', 'nu_u_dot_3', 'nu_u_dot_4', 'nu_u_dot_5'], 'lines': [['nu_u_dot_0', 'nu_e_0 + bend_0*h
+ k*turn_0'], ['nu_u_dot_1', 'nu_e_1 + bend_1*h + k*turn_1'], ['nu_u_dot_2', 'nu_e_2 + bend_2*h +
k*turn_2'], ['nu_u_dot_3', 'nu_e_3 + bend_3*h + k*turn_3 + tail_3*twofold'], ['nu_u_dot_4', 'nu_e_4
+ bend_4*h + k*turn_4 + tail_4*twofold'], ['nu_u_dot_5', 'nu_e_5 + bend_5*h + k*turn_5 +
tail_5*twofold']], 'cases': []}, {'name': 'drive', 'size': 6, 'unit': 'rad/s, m/s', 'doc': 'lambda
nu_u', 'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['drive_0', 'drive_1',
'drive_2', 'drive_3', 'drive_4', 'drive_5'], 'lines': [['drive_0', 'phi_0*rate_gain'], ['drive_1',
'phi_1*rate_gain'], ['drive_2', 'phi_2*rate_gain'], ['drive_3', 'rate_gain*rho_p_0'], ['drive_4',
'rate_gain*rho_p_1'], ['drive_5', 'rate_gain*rho_p_2']], 'cases': []}, {'name': 's', 'size': 6,
'unit': 'rad/s, m/s', 'doc': 'sliding variable', 'source': 'eq. (SurfaceErr)', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['s_0', 's_1', 's_2', 's_3', 's_4', 's_5'], 'lines': [['s_0',
'drive_0 + nu_e_0'], ['s_1', 'drive_1 + nu_e_1'], ['s_2', 'drive_2 + nu_e_2'], ['s_3', 'drive_3 +
nu_e_3'], ['s_4', 'drive_4 + nu_e_4'], ['s_5', 'drive_5 + nu_e_5']], 'cases': []}, {'name':
'wanted', 'size': 6, 'unit': 'rad/s^2, m/s^2', 'doc': 'acceleration asked for', 'source': '',
'is_scalar': False, 'holder': '', 'member': '', 'names': ['wanted_0', 'wanted_1', 'wanted_2',
'wanted_3', 'wanted_4', 'wanted_5'], 'lines': [['wanted_0', 'eta_dot_0 - nu_u_dot_0*rate_gain -
reach_gain*s_0'], ['wanted_1', 'eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1'], ['wanted_2',
'eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2'], ['wanted_3', 'eta_dot_3 - nu_u_dot_3*rate_gain
- reach_gain*s_3'], ['wanted_4', 'eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4'], ['wanted_5',
'eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5']], 'cases': []}, {'name': 'turning', 'size': 6,
'unit': 'rad/s, m/s', 'doc': 'lambda nu_u - eta, as s - nu', 'source': '', 'is_scalar': False,
'holder': '', 'member': '', 'names': ['turning_0', 'turning_1', 'turning_2', 'turning_3',
'turning_4', 'turning_5'], 'lines': [['turning_0', 's_0 - nu_0'], ['turning_1', 's_1 - nu_1'],
['turning_2', 's_2 - nu_2'], ['turning_3', 's_3 - nu_3'], ['turning_4', 's_4 - nu_4'], ['turning_5',
's_5 - nu_5']], 'cases': []}, {'name': 'momentum', 'size': 6, 'unit': 'N m s, N s', 'doc': 'I nu',
'source': '', 'is_scalar': False, 'holder': '', 'member': '', 'names': ['momentum_0', 'momentum_1',
'momentum_2', 'momentum_3', 'momentum_4', 'momentum_5'], 'lines': [['momentum_0', 'inertia_0*nu_0 +
inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 + inertia_5*nu_5'], ['momentum_1', 'inertia_1*nu_0
+ inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 + inertia_8*nu_3'], ['momentum_2',
'inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 + inertia_7*nu_1'],
['momentum_3', 'inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1'], ['momentum_4',
'inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0'], ['momentum_5', 'inertia_10*nu_1 +
inertia_20*nu_5 + inertia_5*nu_0']], 'cases': []}, {'name': 'force', 'size': 6, 'unit': 'N m, N',
'doc': 'control force, I f_u', 'source': 'eq. (TckCtrl)', 'is_scalar': False, 'holder': '',
'member': '', 'names': ['force_0', 'force_1', 'force_2', 'force_3', 'force_4', 'force_5'], 'lines':
[['force_0', 'inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 + inertia_4*wanted_4 +
inertia_5*wanted_5 + momentum_1*turning_2 + momentum_4*turning_5 - momentum_2*turning_1 -
momentum_5*turning_4'], ['force_1', 'inertia_1*wanted_0 + inertia_10*wanted_5 + inertia_6*wanted_1 +
inertia_7*wanted_2 + inertia_8*wanted_3 + momentum_2*turning_0 + momentum_5*turning_3 -
momentum_0*turning_2 - momentum_3*turning_5'], ['force_2', 'inertia_11*wanted_2 +
inertia_12*wanted_3 + inertia_13*wanted_4 + inertia_2*wanted_0 + inertia_7*wanted_1 +
momentum_0*turning_1 + momentum_3*turning_4 - momentum_1*turning_0 - momentum_4*turning_3'],
['force_3', 'inertia_12*wanted_2 + inertia_15*wanted_3 + inertia_8*wanted_1 + momentum_4*turning_2 -
momentum_5*turning_1'], ['force_4', 'inertia_13*wanted_2 + inertia_18*wanted_4 + inertia_4*wanted_0
+ momentum_5*turning_0 - momentum_3*turning_2'], ['force_5', 'inertia_10*wanted_1 +
inertia_20*wanted_5 + inertia_5*wanted_0 + momentum_3*turning_1 - momentum_4*turning_0']], 'cases':
[]}], 'outputs': [{'name': 'force', 'size': 6, 'unit': 'N m, N', 'doc': 'control force', 'source':
'', 'is_scalar': False, 'holder': 'command', 'member': 'force', 'entries': ['force_0', 'force_1',
'force_2', 'force_3', 'force_4', 'force_5']}, {'name': 's', 'size': 6, 'unit': 'rad/s, m/s', 'doc':
'sliding variable', 'source': '', 'is_scalar': False, 'holder': 'command', 'member': 's', 'entries':
['s_0', 's_1', 's_2', 's_3', 's_4', 's_5']}, {'name': 'nu_u', 'size': 6, 'unit': 'rad, m', 'doc':
'kinematic law', 'source': '', 'is_scalar': False, 'holder': 'command', 'member': 'nu_u', 'entries':
['phi_0', 'phi_1', 'phi_2', 'rho_p_0', 'rho_p_1', 'rho_p_2']}, {'name': 'nu_u_dot', 'size': 6,
'unit': 'rad/s, m/s', 'doc': 'its exact rate', 'source': '', 'is_scalar': False, 'holder':
'command', 'member': 'nu_u_dot', 'entries': ['nu_u_dot_0', 'nu_u_dot_1', 'nu_u_dot_2', 'nu_u_dot_3',
'nu_u_dot_4', 'nu_u_dot_5']}, {'name': 'clearance', 'size': 1, 'unit': '1', 'doc': 'distance from
the cut locus of the law', 'source': '', 'is_scalar': True, 'holder': '', 'member': 'clearance',
'entries': ['w']}], 'operations': 486, 'temporaries': 135, 'symbol': 'tracking', 'is_public': False,
'holders': ['params', 'state', 'reference'], 'arguments': ['nu', 'nu_r', 'nu_r_dot', 'g_e'],
'has_reference': True, 'writes': ['command', 'clearance'], 'public_writes': ['command',
'clearance']}, double precision, batched.

Generated by derive from the vehicle file freeflyer.toml; regenerate instead of editing.
Configuration: matrix of 4 rows, row by row.
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
          MAX_ENTRY, MAX_ENTRY, MAX_ENTRY, MAX_REACH, MAX_ENTRY, MAX_ENTRY, MAX_ENTRY,
          MAX_ENTRY)  # of the error's entries
FREE = np.array(BOUNDS) > MAX_ENTRY
CHUNK = 4096  # rows computed together, so that their temporaries stay in the cache
Array = Any  # a numpy array, or what np.asarray makes one of


class Params(NamedTuple):
    """Inertia, upper triangle row by row (..., 21), and gains, each (...).

    What `control` keeps to has the vehicle's values where it is left out.
    """

    inertia: Array
    lambda_: Array
    k_s: Array
    force_limit: Array = (0.3, 0.3, 0.3, 1.5, 1.0, 1.0)  # largest force of each coordinate [N m, N]
    max_drift: Array = 1.0e-6  # largest distance of the error from the group [1]


class Command(NamedTuple):
    """Force, sliding variable, law and its exact rate, (..., 6) each; status (...)."""

    force: Array
    s: Array
    nu_u: Array
    nu_u_dot: Array
    status: Array


DEFAULTS = Params(
    inertia=(0.15334, 0.0046, -0.005, 0.0, -0.05, 0.03, 0.16625, 0.00185, 0.05, 0.0, 0.2, 0.14709,
        -0.03, -0.2, 0.0, 1.0e1, 0.0, 0.0, 1.0e1, 0.0, 1.0e1),
    lambda_=0.1,
    k_s=0.4,
)


def control(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Guarded controller: force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl).

    Arguments as for `tracking`, real numbers only, computed and judged in double; TypeError for
    others. Where the status is 16 or larger, the whole command is zero.
    """
    given = [
        _real("inertia", params.inertia, (21,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
        _real("g", g, (4, 4)),
        _real("nu", nu, (6,)),
        _real("g_r", g_r, (4, 4)),
        _real("nu_r", nu_r, (6,)),
        _real("nu_r_dot", nu_r_dot, (6,)),
    ]
    force_limit = _real("force_limit", params.force_limit, (6,))
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
        command[0], status = _saturated(command[0], force_limit)
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
        _real("inertia", params.inertia, (21,)),
        _real("lambda_", params.lambda_, ()),
        _real("k_s", params.k_s, ()),
    ]
    inertia, *gains = given
    with np.errstate(all="ignore"):
        pivots = _batched(_definiteness, [inertia])[0]
        good = (np.abs(inertia) <= MAX_PARAM).all(-1) & (pivots > 0.0).all(-1)
        good = good & (inertia[..., [3, 9, 14, 16, 17, 19]] == 0.0).all(-1)
        good = good & ((gains[0] >= MIN_GAIN) & (gains[0] <= MAX_RATE))[..., 0]
        good = good & ((gains[1] >= MIN_GAIN) & (gains[1] <= MAX_RATE))[..., 0]
        limit = _real("force_limit", params.force_limit, (6,))
        good = good & ((limit >= MIN_GAIN) & (limit <= MAX_PARAM)).all(-1)
        drift = _real("max_drift", params.max_drift, ())
        good = good & ((drift > 0.0) & (drift <= MOST_DRIFT))[..., 0]
    return np.where(good, OK, BAD_PARAMS)


def tracking(
    g: Array, nu: Array, g_r: Array, nu_r: Array, nu_r_dot: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl). Presumes what `control` checks.

    g: configuration: matrix of 4 rows, row by row [1], (..., 4, 4)
    nu: body velocity [rad/s, m/s], (..., 6)
    g_r: reference configuration: matrix of 4 rows, row by row [1], (..., 4, 4)
    nu_r: reference velocity, reference body frame [rad/s, m/s], (..., 6)
    nu_r_dot: its rate [rad/s^2, m/s^2], (..., 6)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (21,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (4, 4)),
        _rows("nu", nu, (6,)),
        _rows("g_r", g_r, (4, 4)),
        _rows("nu_r", nu_r, (6,)),
        _rows("nu_r_dot", nu_r_dot, (6,)),
    ]
    command = _batched(_law, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def reaching(
    g: Array, nu: Array, params: Params = DEFAULTS
) -> Command:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2). Presumes what `control` checks.

    g: configuration: matrix of 4 rows, row by row [1], (..., 4, 4)
    nu: body velocity [rad/s, m/s], (..., 6)
    Nothing is judged: every status is OK.
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (21,)),
        _rows("lambda_", params.lambda_, ()),
        _rows("k_s", params.k_s, ()),
        _rows("g", g, (4, 4)),
        _rows("nu", nu, (6,)),
    ]
    command = _batched(_reaching, given)[:4]
    return Command(*command, np.full(command[0].shape[:-1], OK))


def plant(
    nu: Array, force: Array, params: Params = DEFAULTS
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP). Presumes what `control` checks.

    nu: body velocity [rad/s, m/s], (..., 6)
    force: applied force [N m, N], (..., 6)
    Complex arrays pass through, for complex-step derivatives.
    """
    given = [
        _rows("inertia", params.inertia, (21,)),
        _rows("nu", nu, (6,)),
        _rows("force", force, (6,)),
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


def _saturated(force: Array, limit: Array) -> tuple[Array, Array]:
    """The force within its limits, (..., 6), and OK, SATURATED or NONFINITE_INPUT, (...)."""
    size = np.abs(force)
    cut = force
    cut = np.where(cut > limit, limit, np.where(cut < -limit, -limit, cut))
    usable = (np.isfinite(force) & (np.abs(cut) <= limit)).all(-1)
    within = (size <= limit).all(-1)
    status = np.where(within, OK, np.where(usable, SATURATED, NONFINITE_INPUT))
    return np.where(within[..., None], force, cut), status


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
        inertia_0, inertia_1, inertia_2, inertia_4, inertia_5, inertia_6, inertia_7, inertia_8,
        inertia_10, inertia_11, inertia_12, inertia_13, inertia_15, inertia_18, inertia_20,
    ) = (
        inertia[0], inertia[1], inertia[2], inertia[4], inertia[5], inertia[6], inertia[7],
        inertia[8], inertia[10], inertia[11], inertia[12], inertia[13], inertia[15], inertia[18],
        inertia[20]
    )
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5 = nu[0], nu[1], nu[2], nu[3], nu[4], nu[5]
    g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8, g_r_9, g_r_10, g_r_11 = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8], g_r[9], g_r[10],
        g_r[11]
    )
    nu_r_0, nu_r_1, nu_r_2, nu_r_3, nu_r_4, nu_r_5 = (
        nu_r[0], nu_r[1], nu_r[2], nu_r[3], nu_r[4], nu_r[5]
    )
    nu_r_dot_0, nu_r_dot_1, nu_r_dot_2, nu_r_dot_3, nu_r_dot_4, nu_r_dot_5 = (
        nu_r_dot[0], nu_r_dot[1], nu_r_dot[2], nu_r_dot[3], nu_r_dot[4], nu_r_dot[5]
    )
    # gap_0: translation of g from g_r [m]
    gap_0_0 = g_3 - g_r_3
    gap_0_1 = g_7 - g_r_7
    gap_0_2 = g_11 - g_r_11
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8
    g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8
    g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4
    g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2
    g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9
    g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9
    g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5
    g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2
    g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10
    g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10
    g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6
    g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1
    # eta_arm_0: velocity at p [m/s]
    eta_arm_0_0 = nu_r_3 + g_e_11*nu_r_1 - g_e_7*nu_r_2
    eta_arm_0_1 = nu_r_4 + g_e_3*nu_r_2 - g_e_11*nu_r_0
    eta_arm_0_2 = nu_r_5 + g_e_7*nu_r_0 - g_e_3*nu_r_1
    # eta: reference velocity in the body frame [rad/s, m/s], eq. (velErr)
    eta_0 = g_e_0*nu_r_0 + g_e_4*nu_r_1 + g_e_8*nu_r_2
    eta_1 = g_e_1*nu_r_0 + g_e_5*nu_r_1 + g_e_9*nu_r_2
    eta_2 = g_e_10*nu_r_2 + g_e_2*nu_r_0 + g_e_6*nu_r_1
    eta_3 = eta_arm_0_0*g_e_0 + eta_arm_0_1*g_e_4 + eta_arm_0_2*g_e_8
    eta_4 = eta_arm_0_0*g_e_1 + eta_arm_0_1*g_e_5 + eta_arm_0_2*g_e_9
    eta_5 = eta_arm_0_0*g_e_2 + eta_arm_0_1*g_e_6 + eta_arm_0_2*g_e_10
    # nu_e: velocity error [rad/s, m/s], eq. (velErr)
    nu_e_0 = nu_0 - eta_0
    nu_e_1 = nu_1 - eta_1
    nu_e_2 = nu_2 - eta_2
    nu_e_3 = nu_3 - eta_3
    nu_e_4 = nu_4 - eta_4
    nu_e_5 = nu_5 - eta_5
    # eta_dot_arm_0: velocity at p [m/s]
    eta_dot_arm_0_0 = nu_r_dot_3 + g_e_11*nu_r_dot_1 - g_e_7*nu_r_dot_2
    eta_dot_arm_0_1 = nu_r_dot_4 + g_e_3*nu_r_dot_2 - g_e_11*nu_r_dot_0
    eta_dot_arm_0_2 = nu_r_dot_5 + g_e_7*nu_r_dot_0 - g_e_3*nu_r_dot_1
    # eta_dot: exact rate of eta [rad/s^2, m/s^2]
    eta_dot_0 = eta_1*nu_e_2 + g_e_0*nu_r_dot_0 + g_e_4*nu_r_dot_1 + g_e_8*nu_r_dot_2 - eta_2*nu_e_1
    eta_dot_1 = eta_2*nu_e_0 + g_e_1*nu_r_dot_0 + g_e_5*nu_r_dot_1 + g_e_9*nu_r_dot_2 - eta_0*nu_e_2
    eta_dot_2 = (
        eta_0*nu_e_1 + g_e_10*nu_r_dot_2 + g_e_2*nu_r_dot_0 + g_e_6*nu_r_dot_1 - eta_1*nu_e_0
    )
    eta_dot_3 = (
        eta_1*nu_e_5 + eta_4*nu_e_2 + eta_dot_arm_0_0*g_e_0 + eta_dot_arm_0_1*g_e_4 +
        eta_dot_arm_0_2*g_e_8 - eta_2*nu_e_4 - eta_5*nu_e_1
    )
    eta_dot_4 = (
        eta_2*nu_e_3 + eta_5*nu_e_0 + eta_dot_arm_0_0*g_e_1 + eta_dot_arm_0_1*g_e_5 +
        eta_dot_arm_0_2*g_e_9 - eta_0*nu_e_5 - eta_3*nu_e_2
    )
    eta_dot_5 = (
        eta_0*nu_e_4 + eta_3*nu_e_1 + eta_dot_arm_0_0*g_e_2 + eta_dot_arm_0_1*g_e_6 +
        eta_dot_arm_0_2*g_e_10 - eta_1*nu_e_3 - eta_4*nu_e_0
    )
    # pairs: what B's diagonal is made of [1]
    pairs_0 = 1.0 + g_e_0
    pairs_1 = 1.0 - g_e_0
    pairs_2 = g_e_10 + g_e_5
    pairs_3 = g_e_5 - g_e_10
    # B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_0 = pairs_0 - pairs_2
    B_1 = g_e_1 + g_e_4
    B_2 = g_e_2 + g_e_8
    B_3 = g_e_9 - g_e_6
    B_4 = pairs_1 + pairs_3
    B_5 = g_e_6 + g_e_9
    B_6 = g_e_2 - g_e_8
    B_7 = pairs_1 - pairs_3
    B_8 = g_e_4 - g_e_1
    B_9 = pairs_0 + pairs_2
    # column: a column of B that cannot vanish [1]
    column_if_0 = B_9.real >= 1.0
    column_if_1 = (B_0.real >= B_4.real) & (B_0.real >= B_7.real)
    column_if_2 = B_4.real >= B_7.real
    column_0 = (
        np.where(column_if_0, B_3, np.where(column_if_1, B_0, np.where(column_if_2, B_1, B_2)))
    )
    column_1 = (
        np.where(column_if_0, B_6, np.where(column_if_1, B_1, np.where(column_if_2, B_4, B_5)))
    )
    column_2 = (
        np.where(column_if_0, B_8, np.where(column_if_1, B_2, np.where(column_if_2, B_5, B_7)))
    )
    column_3 = (
        np.where(column_if_0, B_9, np.where(column_if_1, B_3, np.where(column_if_2, B_6, B_8)))
    )
    # power: the column after one power step [1]
    power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3
    power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3
    power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3
    power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3
    # square: square of its vector part [1]
    square = power_0*power_0 + power_1*power_1 + power_2*power_2
    # norm_square: its squared length [1]
    norm_square = square + power_3*power_3
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 49.0
    norm_bounded = np.where(norm_bounded_if_0, 49.0, norm_square)
    # norm: its length [1]
    norm = np.sqrt(norm_bounded)
    # inverse_norm: to unit length [1]
    inverse_norm = 1.0/norm
    # scale: to unit length, and to w >= 0: the shorter way round [1]
    scale_if_0 = power_3.real < 0.0
    scale = np.where(scale_if_0, -inverse_norm, inverse_norm)
    # cosine: cos of half the error angle, rounded [1]
    cosine = power_3*scale
    # w: cos of half the error angle [1]
    w_if_0 = cosine.real > 1.0
    w = np.where(w_if_0, 1.0, cosine)
    # v: sin of half the error angle times its axis [1]
    v_0 = power_0*scale
    v_1 = power_1*scale
    v_2 = power_2*scale
    # k: half angle over its sine [1]
    k = _k(w)
    # h: -dk/dw [1]
    h = _h(w)
    # phi: rotation vector of the error [rad]
    phi_0 = 2.0*k*v_0
    phi_1 = 2.0*k*v_1
    phi_2 = 2.0*k*v_2
    # half: 1/(2 k) [1]
    half = 0.5/k
    # swing_p: Y p [m]
    swing_p_0 = g_e_11*v_1 - g_e_7*v_2
    swing_p_1 = g_e_3*v_2 - g_e_11*v_0
    swing_p_2 = g_e_7*v_0 - g_e_3*v_1
    # sway_p: Y Y p [m]
    sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2
    sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0
    sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1
    # rho_p: p - k Y p + h Y Y p [m]
    rho_p_0 = g_e_3 + h*sway_p_0 - k*swing_p_0
    rho_p_1 = g_e_7 + h*sway_p_1 - k*swing_p_1
    rho_p_2 = g_e_11 + h*sway_p_2 - k*swing_p_2
    # y_p: rho/(2 k) [m]
    y_p_0 = half*rho_p_0
    y_p_1 = half*rho_p_1
    y_p_2 = half*rho_p_2
    # turn: Y nu_e, Y = ad of y [rad/s, m/s]
    turn_0 = nu_e_2*v_1 - nu_e_1*v_2
    turn_1 = nu_e_0*v_2 - nu_e_2*v_0
    turn_2 = nu_e_1*v_0 - nu_e_0*v_1
    turn_3 = nu_e_2*y_p_1 + nu_e_5*v_1 - nu_e_1*y_p_2 - nu_e_4*v_2
    turn_4 = nu_e_0*y_p_2 + nu_e_3*v_2 - nu_e_2*y_p_0 - nu_e_5*v_0
    turn_5 = nu_e_1*y_p_0 + nu_e_4*v_0 - nu_e_0*y_p_1 - nu_e_3*v_1
    # bend: Y Y nu_e [rad/s, m/s]
    bend_0 = turn_2*v_1 - turn_1*v_2
    bend_1 = turn_0*v_2 - turn_2*v_0
    bend_2 = turn_1*v_0 - turn_0*v_1
    bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2
    bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0
    bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1
    # m: -dh/dw [1]
    m = _m(w)
    # along_p: -2 v.q [m]
    along_p = -2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2)
    # tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s]
    tail_3 = along_p*bend_0
    tail_4 = along_p*bend_1
    tail_5 = along_p*bend_2
    # twofold: h^2 - k m/2, of the double root [1]
    twofold = h*h - 0.5*k*m
    # nu_u_dot: exact rate of nu_u [rad/s, m/s]
    nu_u_dot_0 = nu_e_0 + bend_0*h + k*turn_0
    nu_u_dot_1 = nu_e_1 + bend_1*h + k*turn_1
    nu_u_dot_2 = nu_e_2 + bend_2*h + k*turn_2
    nu_u_dot_3 = nu_e_3 + bend_3*h + k*turn_3 + tail_3*twofold
    nu_u_dot_4 = nu_e_4 + bend_4*h + k*turn_4 + tail_4*twofold
    nu_u_dot_5 = nu_e_5 + bend_5*h + k*turn_5 + tail_5*twofold
    # drive: lambda nu_u [rad/s, m/s]
    drive_0 = phi_0*rate_gain
    drive_1 = phi_1*rate_gain
    drive_2 = phi_2*rate_gain
    drive_3 = rate_gain*rho_p_0
    drive_4 = rate_gain*rho_p_1
    drive_5 = rate_gain*rho_p_2
    # s: sliding variable [rad/s, m/s], eq. (SurfaceErr)
    s_0 = drive_0 + nu_e_0
    s_1 = drive_1 + nu_e_1
    s_2 = drive_2 + nu_e_2
    s_3 = drive_3 + nu_e_3
    s_4 = drive_4 + nu_e_4
    s_5 = drive_5 + nu_e_5
    # wanted: acceleration asked for [rad/s^2, m/s^2]
    wanted_0 = eta_dot_0 - nu_u_dot_0*rate_gain - reach_gain*s_0
    wanted_1 = eta_dot_1 - nu_u_dot_1*rate_gain - reach_gain*s_1
    wanted_2 = eta_dot_2 - nu_u_dot_2*rate_gain - reach_gain*s_2
    wanted_3 = eta_dot_3 - nu_u_dot_3*rate_gain - reach_gain*s_3
    wanted_4 = eta_dot_4 - nu_u_dot_4*rate_gain - reach_gain*s_4
    wanted_5 = eta_dot_5 - nu_u_dot_5*rate_gain - reach_gain*s_5
    # turning: lambda nu_u - eta, as s - nu [rad/s, m/s]
    turning_0 = s_0 - nu_0
    turning_1 = s_1 - nu_1
    turning_2 = s_2 - nu_2
    turning_3 = s_3 - nu_3
    turning_4 = s_4 - nu_4
    turning_5 = s_5 - nu_5
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 + inertia_5*nu_5
    momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 + inertia_8*nu_3
    momentum_2 = (
        inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 + inertia_7*nu_1
    )
    momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1
    momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0
    # force: control force, I f_u [N m, N], eq. (TckCtrl)
    force_0 = (
        inertia_0*wanted_0 + inertia_1*wanted_1 + inertia_2*wanted_2 + inertia_4*wanted_4 +
        inertia_5*wanted_5 + momentum_1*turning_2 + momentum_4*turning_5 - momentum_2*turning_1 -
        momentum_5*turning_4
    )
    force_1 = (
        inertia_1*wanted_0 + inertia_10*wanted_5 + inertia_6*wanted_1 + inertia_7*wanted_2 +
        inertia_8*wanted_3 + momentum_2*turning_0 + momentum_5*turning_3 - momentum_0*turning_2 -
        momentum_3*turning_5
    )
    force_2 = (
        inertia_11*wanted_2 + inertia_12*wanted_3 + inertia_13*wanted_4 + inertia_2*wanted_0 +
        inertia_7*wanted_1 + momentum_0*turning_1 + momentum_3*turning_4 - momentum_1*turning_0 -
        momentum_4*turning_3
    )
    force_3 = (
        inertia_12*wanted_2 + inertia_15*wanted_3 + inertia_8*wanted_1 + momentum_4*turning_2 -
        momentum_5*turning_1
    )
    force_4 = (
        inertia_13*wanted_2 + inertia_18*wanted_4 + inertia_4*wanted_0 + momentum_5*turning_0 -
        momentum_3*turning_2
    )
    force_5 = (
        inertia_10*wanted_1 + inertia_20*wanted_5 + inertia_5*wanted_0 + momentum_3*turning_1 -
        momentum_4*turning_0
    )
    # -- end --
    return (
        (force_0, force_1, force_2, force_3, force_4, force_5),
        (s_0, s_1, s_2, s_3, s_4, s_5),
        (phi_0, phi_1, phi_2, rho_p_0, rho_p_1, rho_p_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2, nu_u_dot_3, nu_u_dot_4, nu_u_dot_5),
        (w,),
    )


def _reaching(
    inertia: Array, lambda_: Array, k_s: Array, g: Array, nu: Array,
) -> Array:
    """Force that drives (g, nu) to (e, 0); eq. (Ctrl2)."""
    # -- reaching --
    (
        inertia_0, inertia_1, inertia_2, inertia_4, inertia_5, inertia_6, inertia_7, inertia_8,
        inertia_10, inertia_11, inertia_12, inertia_13, inertia_15, inertia_18, inertia_20,
    ) = (
        inertia[0], inertia[1], inertia[2], inertia[4], inertia[5], inertia[6], inertia[7],
        inertia[8], inertia[10], inertia[11], inertia[12], inertia[13], inertia[15], inertia[18],
        inertia[20]
    )
    rate_gain = lambda_[0]
    reach_gain = k_s[0]
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5 = nu[0], nu[1], nu[2], nu[3], nu[4], nu[5]
    # pairs: what B's diagonal is made of [1]
    pairs_0 = 1.0 + g_0
    pairs_1 = 1.0 - g_0
    pairs_2 = g_10 + g_5
    pairs_3 = g_5 - g_10
    # B: 4 p p^T, p = (v, w), by rows [1], polar factor of Markley and Bar-Itzhack
    B_0 = pairs_0 - pairs_2
    B_1 = g_1 + g_4
    B_2 = g_2 + g_8
    B_3 = g_9 - g_6
    B_4 = pairs_1 + pairs_3
    B_5 = g_6 + g_9
    B_6 = g_2 - g_8
    B_7 = pairs_1 - pairs_3
    B_8 = g_4 - g_1
    B_9 = pairs_0 + pairs_2
    # column: a column of B that cannot vanish [1]
    column_if_0 = B_9.real >= 1.0
    column_if_1 = (B_0.real >= B_4.real) & (B_0.real >= B_7.real)
    column_if_2 = B_4.real >= B_7.real
    column_0 = (
        np.where(column_if_0, B_3, np.where(column_if_1, B_0, np.where(column_if_2, B_1, B_2)))
    )
    column_1 = (
        np.where(column_if_0, B_6, np.where(column_if_1, B_1, np.where(column_if_2, B_4, B_5)))
    )
    column_2 = (
        np.where(column_if_0, B_8, np.where(column_if_1, B_2, np.where(column_if_2, B_5, B_7)))
    )
    column_3 = (
        np.where(column_if_0, B_9, np.where(column_if_1, B_3, np.where(column_if_2, B_6, B_8)))
    )
    # power: the column after one power step [1]
    power_0 = B_0*column_0 + B_1*column_1 + B_2*column_2 + B_3*column_3
    power_1 = B_1*column_0 + B_4*column_1 + B_5*column_2 + B_6*column_3
    power_2 = B_2*column_0 + B_5*column_1 + B_7*column_2 + B_8*column_3
    power_3 = B_3*column_0 + B_6*column_1 + B_8*column_2 + B_9*column_3
    # square: square of its vector part [1]
    square = power_0*power_0 + power_1*power_1 + power_2*power_2
    # norm_square: its squared length [1]
    norm_square = square + power_3*power_3
    # norm_bounded: the same: less is no element [1]
    norm_bounded_if_0 = norm_square.real < 49.0
    norm_bounded = np.where(norm_bounded_if_0, 49.0, norm_square)
    # norm: its length [1]
    norm = np.sqrt(norm_bounded)
    # inverse_norm: to unit length [1]
    inverse_norm = 1.0/norm
    # scale: to unit length, and to w >= 0: the shorter way round [1]
    scale_if_0 = power_3.real < 0.0
    scale = np.where(scale_if_0, -inverse_norm, inverse_norm)
    # cosine: cos of half the error angle, rounded [1]
    cosine = power_3*scale
    # w: cos of half the error angle [1]
    w_if_0 = cosine.real > 1.0
    w = np.where(w_if_0, 1.0, cosine)
    # v: sin of half the error angle times its axis [1]
    v_0 = power_0*scale
    v_1 = power_1*scale
    v_2 = power_2*scale
    # k: half angle over its sine [1]
    k = _k(w)
    # h: -dk/dw [1]
    h = _h(w)
    # phi: rotation vector of the error [rad]
    phi_0 = 2.0*k*v_0
    phi_1 = 2.0*k*v_1
    phi_2 = 2.0*k*v_2
    # half: 1/(2 k) [1]
    half = 0.5/k
    # swing_p: Y p [m]
    swing_p_0 = g_11*v_1 - g_7*v_2
    swing_p_1 = g_3*v_2 - g_11*v_0
    swing_p_2 = g_7*v_0 - g_3*v_1
    # sway_p: Y Y p [m]
    sway_p_0 = swing_p_2*v_1 - swing_p_1*v_2
    sway_p_1 = swing_p_0*v_2 - swing_p_2*v_0
    sway_p_2 = swing_p_1*v_0 - swing_p_0*v_1
    # rho_p: p - k Y p + h Y Y p [m]
    rho_p_0 = g_3 + h*sway_p_0 - k*swing_p_0
    rho_p_1 = g_7 + h*sway_p_1 - k*swing_p_1
    rho_p_2 = g_11 + h*sway_p_2 - k*swing_p_2
    # y_p: rho/(2 k) [m]
    y_p_0 = half*rho_p_0
    y_p_1 = half*rho_p_1
    y_p_2 = half*rho_p_2
    # turn: Y nu_e, Y = ad of y [rad/s, m/s]
    turn_0 = nu_2*v_1 - nu_1*v_2
    turn_1 = nu_0*v_2 - nu_2*v_0
    turn_2 = nu_1*v_0 - nu_0*v_1
    turn_3 = nu_2*y_p_1 + nu_5*v_1 - nu_1*y_p_2 - nu_4*v_2
    turn_4 = nu_0*y_p_2 + nu_3*v_2 - nu_2*y_p_0 - nu_5*v_0
    turn_5 = nu_1*y_p_0 + nu_4*v_0 - nu_0*y_p_1 - nu_3*v_1
    # bend: Y Y nu_e [rad/s, m/s]
    bend_0 = turn_2*v_1 - turn_1*v_2
    bend_1 = turn_0*v_2 - turn_2*v_0
    bend_2 = turn_1*v_0 - turn_0*v_1
    bend_3 = turn_2*y_p_1 + turn_5*v_1 - turn_1*y_p_2 - turn_4*v_2
    bend_4 = turn_0*y_p_2 + turn_3*v_2 - turn_2*y_p_0 - turn_5*v_0
    bend_5 = turn_1*y_p_0 + turn_4*v_0 - turn_0*y_p_1 - turn_3*v_1
    # m: -dh/dw [1]
    m = _m(w)
    # along_p: -2 v.q [m]
    along_p = -2.0*(v_0*y_p_0 + v_1*y_p_1 + v_2*y_p_2)
    # tail: (Y^2 + s^2) Y^2 nu_e [rad/s, m/s]
    tail_3 = along_p*bend_0
    tail_4 = along_p*bend_1
    tail_5 = along_p*bend_2
    # twofold: h^2 - k m/2, of the double root [1]
    twofold = h*h - 0.5*k*m
    # nu_u_dot: exact rate of nu_u [rad/s, m/s]
    nu_u_dot_0 = nu_0 + bend_0*h + k*turn_0
    nu_u_dot_1 = nu_1 + bend_1*h + k*turn_1
    nu_u_dot_2 = nu_2 + bend_2*h + k*turn_2
    nu_u_dot_3 = nu_3 + bend_3*h + k*turn_3 + tail_3*twofold
    nu_u_dot_4 = nu_4 + bend_4*h + k*turn_4 + tail_4*twofold
    nu_u_dot_5 = nu_5 + bend_5*h + k*turn_5 + tail_5*twofold
    # drive: lambda nu_u [rad/s, m/s]
    drive_0 = phi_0*rate_gain
    drive_1 = phi_1*rate_gain
    drive_2 = phi_2*rate_gain
    drive_3 = rate_gain*rho_p_0
    drive_4 = rate_gain*rho_p_1
    drive_5 = rate_gain*rho_p_2
    # s: sliding variable [rad/s, m/s], eq. (sldS)
    s_0 = drive_0 + nu_0
    s_1 = drive_1 + nu_1
    s_2 = drive_2 + nu_2
    s_3 = drive_3 + nu_3
    s_4 = drive_4 + nu_4
    s_5 = drive_5 + nu_5
    # wanted: acceleration asked for [rad/s^2, m/s^2]
    wanted_0 = -(nu_u_dot_0*rate_gain + reach_gain*s_0)
    wanted_1 = -(nu_u_dot_1*rate_gain + reach_gain*s_1)
    wanted_2 = -(nu_u_dot_2*rate_gain + reach_gain*s_2)
    wanted_3 = -(nu_u_dot_3*rate_gain + reach_gain*s_3)
    wanted_4 = -(nu_u_dot_4*rate_gain + reach_gain*s_4)
    wanted_5 = -(nu_u_dot_5*rate_gain + reach_gain*s_5)
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 + inertia_5*nu_5
    momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 + inertia_8*nu_3
    momentum_2 = (
        inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 + inertia_7*nu_1
    )
    momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1
    momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0
    # force: control force, I f_u [N m, N], eq. (Ctrl2)
    force_0 = (
        drive_2*momentum_1 + drive_5*momentum_4 + inertia_0*wanted_0 + inertia_1*wanted_1 +
        inertia_2*wanted_2 + inertia_4*wanted_4 + inertia_5*wanted_5 - drive_1*momentum_2 -
        drive_4*momentum_5
    )
    force_1 = (
        drive_0*momentum_2 + drive_3*momentum_5 + inertia_1*wanted_0 + inertia_10*wanted_5 +
        inertia_6*wanted_1 + inertia_7*wanted_2 + inertia_8*wanted_3 - drive_2*momentum_0 -
        drive_5*momentum_3
    )
    force_2 = (
        drive_1*momentum_0 + drive_4*momentum_3 + inertia_11*wanted_2 + inertia_12*wanted_3 +
        inertia_13*wanted_4 + inertia_2*wanted_0 + inertia_7*wanted_1 - drive_0*momentum_1 -
        drive_3*momentum_4
    )
    force_3 = (
        drive_2*momentum_4 + inertia_12*wanted_2 + inertia_15*wanted_3 + inertia_8*wanted_1 -
        drive_1*momentum_5
    )
    force_4 = (
        drive_0*momentum_5 + inertia_13*wanted_2 + inertia_18*wanted_4 + inertia_4*wanted_0 -
        drive_2*momentum_3
    )
    force_5 = (
        drive_1*momentum_3 + inertia_10*wanted_1 + inertia_20*wanted_5 + inertia_5*wanted_0 -
        drive_0*momentum_4
    )
    # -- end --
    return (
        (force_0, force_1, force_2, force_3, force_4, force_5),
        (s_0, s_1, s_2, s_3, s_4, s_5),
        (phi_0, phi_1, phi_2, rho_p_0, rho_p_1, rho_p_2),
        (nu_u_dot_0, nu_u_dot_1, nu_u_dot_2, nu_u_dot_3, nu_u_dot_4, nu_u_dot_5),
    )


def _plant(
    inertia: Array, nu: Array, force: Array,
) -> Array:
    """Acceleration under a force, Euler-Poincare; eq. (EulerP)."""
    # -- plant --
    (
        inertia_0, inertia_1, inertia_2, inertia_4, inertia_5, inertia_6, inertia_7, inertia_8,
        inertia_10, inertia_11, inertia_12, inertia_13, inertia_15, inertia_18, inertia_20,
    ) = (
        inertia[0], inertia[1], inertia[2], inertia[4], inertia[5], inertia[6], inertia[7],
        inertia[8], inertia[10], inertia[11], inertia[12], inertia[13], inertia[15], inertia[18],
        inertia[20]
    )
    nu_0, nu_1, nu_2, nu_3, nu_4, nu_5 = nu[0], nu[1], nu[2], nu[3], nu[4], nu[5]
    force_0, force_1, force_2, force_3, force_4, force_5 = (
        force[0], force[1], force[2], force[3], force[4], force[5]
    )
    # momentum: I nu [N m s, N s]
    momentum_0 = inertia_0*nu_0 + inertia_1*nu_1 + inertia_2*nu_2 + inertia_4*nu_4 + inertia_5*nu_5
    momentum_1 = inertia_1*nu_0 + inertia_10*nu_5 + inertia_6*nu_1 + inertia_7*nu_2 + inertia_8*nu_3
    momentum_2 = (
        inertia_11*nu_2 + inertia_12*nu_3 + inertia_13*nu_4 + inertia_2*nu_0 + inertia_7*nu_1
    )
    momentum_3 = inertia_12*nu_2 + inertia_15*nu_3 + inertia_8*nu_1
    momentum_4 = inertia_13*nu_2 + inertia_18*nu_4 + inertia_4*nu_0
    momentum_5 = inertia_10*nu_1 + inertia_20*nu_5 + inertia_5*nu_0
    # total: coad(nu) I nu + force [N m, N]
    total_0 = force_0 + momentum_1*nu_2 + momentum_4*nu_5 - momentum_2*nu_1 - momentum_5*nu_4
    total_1 = force_1 + momentum_2*nu_0 + momentum_5*nu_3 - momentum_0*nu_2 - momentum_3*nu_5
    total_2 = force_2 + momentum_0*nu_1 + momentum_3*nu_4 - momentum_1*nu_0 - momentum_4*nu_3
    total_3 = force_3 + momentum_4*nu_2 - momentum_5*nu_1
    total_4 = force_4 + momentum_5*nu_0 - momentum_3*nu_2
    total_5 = force_5 + momentum_3*nu_1 - momentum_4*nu_0
    # lower_10: I = L D L^T, entry of L [1]
    lower_10 = inertia_1/inertia_0
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/inertia_0
    # lower_40: I = L D L^T, entry of L [1]
    lower_40 = inertia_4/inertia_0
    # lower_50: I = L D L^T, entry of L [1]
    lower_50 = inertia_5/inertia_0
    # pivot_1: pivot of I [kg m^2, kg m, kg]
    pivot_1 = inertia_6 - inertia_0*lower_10*lower_10
    # lower_21: I = L D L^T, entry of L [1]
    lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/pivot_1
    # lower_31: I = L D L^T, entry of L [1]
    lower_31 = inertia_8/pivot_1
    # lower_41: I = L D L^T, entry of L [1]
    lower_41 = -inertia_0*lower_10*lower_40/pivot_1
    # lower_51: I = L D L^T, entry of L [1]
    lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/pivot_1
    # pivot_2: pivot of I [kg m^2, kg m, kg]
    pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21
    # lower_32: I = L D L^T, entry of L [1]
    lower_32 = (inertia_12 - lower_21*lower_31*pivot_1)/pivot_2
    # lower_42: I = L D L^T, entry of L [1]
    lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 - lower_21*lower_41*pivot_1)/pivot_2
    # lower_52: I = L D L^T, entry of L [1]
    lower_52 = (-(inertia_0*lower_20*lower_50 + lower_21*lower_51*pivot_1))/pivot_2
    # pivot_3: pivot of I [kg m^2, kg m, kg]
    pivot_3 = inertia_15 - pivot_1*lower_31*lower_31 - pivot_2*lower_32*lower_32
    # lower_43: I = L D L^T, entry of L [1]
    lower_43 = (-(lower_31*lower_41*pivot_1 + lower_32*lower_42*pivot_2))/pivot_3
    # lower_53: I = L D L^T, entry of L [1]
    lower_53 = (-(lower_31*lower_51*pivot_1 + lower_32*lower_52*pivot_2))/pivot_3
    # pivot_4: pivot of I [kg m^2, kg m, kg]
    pivot_4 = (
        inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43
    )
    # lower_54: I = L D L^T, entry of L [1]
    lower_54 = (
        (-(inertia_0*lower_40*lower_50 + lower_41*lower_51*pivot_1 + lower_42*lower_52*pivot_2 +
        lower_43*lower_53*pivot_3))/pivot_4
    )
    # pivot_5: pivot of I [kg m^2, kg m, kg]
    pivot_5 = (
        inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54
    )
    # forward_1: forward substitution [N m, N]
    forward_1 = total_1 - lower_10*total_0
    # forward_2: forward substitution [N m, N]
    forward_2 = total_2 - forward_1*lower_21 - lower_20*total_0
    # forward_3: forward substitution [N m, N]
    forward_3 = total_3 - forward_1*lower_31 - forward_2*lower_32
    # forward_4: forward substitution [N m, N]
    forward_4 = (
        total_4 - forward_1*lower_41 - forward_2*lower_42 - forward_3*lower_43 - lower_40*total_0
    )
    # forward_5: forward substitution [N m, N]
    forward_5 = (
        total_5 - forward_1*lower_51 - forward_2*lower_52 - forward_3*lower_53 - forward_4*lower_54
        - lower_50*total_0
    )
    # back_5: back substitution [rad/s^2, m/s^2]
    back_5 = forward_5/pivot_5
    # back_4: back substitution [rad/s^2, m/s^2]
    back_4 = forward_4/pivot_4 - back_5*lower_54
    # back_3: back substitution [rad/s^2, m/s^2]
    back_3 = forward_3/pivot_3 - back_4*lower_43 - back_5*lower_53
    # back_2: back substitution [rad/s^2, m/s^2]
    back_2 = forward_2/pivot_2 - back_3*lower_32 - back_4*lower_42 - back_5*lower_52
    # back_1: back substitution [rad/s^2, m/s^2]
    back_1 = (
        forward_1/pivot_1 - back_2*lower_21 - back_3*lower_31 - back_4*lower_41 - back_5*lower_51
    )
    # back_0: back substitution [rad/s^2, m/s^2]
    back_0 = (
        total_0/inertia_0 - back_1*lower_10 - back_2*lower_20 - back_4*lower_40 - back_5*lower_50
    )
    # -- end --
    return (
        (back_0, back_1, back_2, back_3, back_4, back_5),
    )


def _definiteness(
    inertia: Array,
) -> Array:
    """Pivots of the inertia: all positive for a valid one."""
    # -- definiteness --
    (
        inertia_0, inertia_1, inertia_2, inertia_4, inertia_5, inertia_6, inertia_7, inertia_8,
        inertia_10, inertia_11, inertia_12, inertia_13, inertia_15, inertia_18, inertia_20,
    ) = (
        inertia[0], inertia[1], inertia[2], inertia[4], inertia[5], inertia[6], inertia[7],
        inertia[8], inertia[10], inertia[11], inertia[12], inertia[13], inertia[15], inertia[18],
        inertia[20]
    )
    # divisor_0: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_0_if_0 = inertia_0.real > 0.0
    divisor_0 = np.where(divisor_0_if_0, inertia_0, 1.0)
    # lower_10: I = L D L^T, entry of L [1]
    lower_10 = inertia_1/divisor_0
    # lower_20: I = L D L^T, entry of L [1]
    lower_20 = inertia_2/divisor_0
    # lower_40: I = L D L^T, entry of L [1]
    lower_40 = inertia_4/divisor_0
    # lower_50: I = L D L^T, entry of L [1]
    lower_50 = inertia_5/divisor_0
    # pivot_1: pivot of I [kg m^2, kg m, kg]
    pivot_1 = inertia_6 - inertia_0*lower_10*lower_10
    # divisor_1: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_1_if_0 = pivot_1.real > 0.0
    divisor_1 = np.where(divisor_1_if_0, pivot_1, 1.0)
    # lower_21: I = L D L^T, entry of L [1]
    lower_21 = (inertia_7 - inertia_0*lower_10*lower_20)/divisor_1
    # lower_31: I = L D L^T, entry of L [1]
    lower_31 = inertia_8/divisor_1
    # lower_41: I = L D L^T, entry of L [1]
    lower_41 = -inertia_0*lower_10*lower_40/divisor_1
    # lower_51: I = L D L^T, entry of L [1]
    lower_51 = (inertia_10 - inertia_0*lower_10*lower_50)/divisor_1
    # pivot_2: pivot of I [kg m^2, kg m, kg]
    pivot_2 = inertia_11 - inertia_0*lower_20*lower_20 - pivot_1*lower_21*lower_21
    # divisor_2: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_2_if_0 = pivot_2.real > 0.0
    divisor_2 = np.where(divisor_2_if_0, pivot_2, 1.0)
    # lower_32: I = L D L^T, entry of L [1]
    lower_32 = (inertia_12 - lower_21*lower_31*pivot_1)/divisor_2
    # lower_42: I = L D L^T, entry of L [1]
    lower_42 = (inertia_13 - inertia_0*lower_20*lower_40 - lower_21*lower_41*pivot_1)/divisor_2
    # lower_52: I = L D L^T, entry of L [1]
    lower_52 = (-(inertia_0*lower_20*lower_50 + lower_21*lower_51*pivot_1))/divisor_2
    # pivot_3: pivot of I [kg m^2, kg m, kg]
    pivot_3 = inertia_15 - pivot_1*lower_31*lower_31 - pivot_2*lower_32*lower_32
    # divisor_3: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_3_if_0 = pivot_3.real > 0.0
    divisor_3 = np.where(divisor_3_if_0, pivot_3, 1.0)
    # lower_43: I = L D L^T, entry of L [1]
    lower_43 = (-(lower_31*lower_41*pivot_1 + lower_32*lower_42*pivot_2))/divisor_3
    # lower_53: I = L D L^T, entry of L [1]
    lower_53 = (-(lower_31*lower_51*pivot_1 + lower_32*lower_52*pivot_2))/divisor_3
    # pivot_4: pivot of I [kg m^2, kg m, kg]
    pivot_4 = (
        inertia_18 - inertia_0*lower_40*lower_40 - pivot_1*lower_41*lower_41 -
        pivot_2*lower_42*lower_42 - pivot_3*lower_43*lower_43
    )
    # divisor_4: the pivot, or 1 where it is not positive [kg m^2, kg m, kg]
    divisor_4_if_0 = pivot_4.real > 0.0
    divisor_4 = np.where(divisor_4_if_0, pivot_4, 1.0)
    # lower_54: I = L D L^T, entry of L [1]
    lower_54 = (
        (-(inertia_0*lower_40*lower_50 + lower_41*lower_51*pivot_1 + lower_42*lower_52*pivot_2 +
        lower_43*lower_53*pivot_3))/divisor_4
    )
    # pivot_5: pivot of I [kg m^2, kg m, kg]
    pivot_5 = (
        inertia_20 - inertia_0*lower_50*lower_50 - pivot_1*lower_51*lower_51 -
        pivot_2*lower_52*lower_52 - pivot_3*lower_53*lower_53 - pivot_4*lower_54*lower_54
    )
    # -- end --
    return (
        (inertia_0, pivot_1, pivot_2, pivot_3, pivot_4, pivot_5),
    )


def _error(
    g: Array, g_r: Array,
) -> Array:
    """Force that drives (g, nu) to (g_r, nu_r); eq. (TckCtrl)."""
    # -- tracking --
    g_0, g_1, g_2, g_3, g_4, g_5, g_6, g_7, g_8, g_9, g_10, g_11 = (
        g[0], g[1], g[2], g[3], g[4], g[5], g[6], g[7], g[8], g[9], g[10], g[11]
    )
    g_r_0, g_r_1, g_r_2, g_r_3, g_r_4, g_r_5, g_r_6, g_r_7, g_r_8, g_r_9, g_r_10, g_r_11 = (
        g_r[0], g_r[1], g_r[2], g_r[3], g_r[4], g_r[5], g_r[6], g_r[7], g_r[8], g_r[9], g_r[10],
        g_r[11]
    )
    # gap_0: translation of g from g_r [m]
    gap_0_0 = g_3 - g_r_3
    gap_0_1 = g_7 - g_r_7
    gap_0_2 = g_11 - g_r_11
    # g_e: error, g_r^-1 g [1], eq. (velErr)
    g_e_0 = g_0*g_r_0 + g_4*g_r_4 + g_8*g_r_8
    g_e_1 = g_1*g_r_0 + g_5*g_r_4 + g_9*g_r_8
    g_e_2 = g_10*g_r_8 + g_2*g_r_0 + g_6*g_r_4
    g_e_3 = g_r_0*gap_0_0 + g_r_4*gap_0_1 + g_r_8*gap_0_2
    g_e_4 = g_0*g_r_1 + g_4*g_r_5 + g_8*g_r_9
    g_e_5 = g_1*g_r_1 + g_5*g_r_5 + g_9*g_r_9
    g_e_6 = g_10*g_r_9 + g_2*g_r_1 + g_6*g_r_5
    g_e_7 = g_r_1*gap_0_0 + g_r_5*gap_0_1 + g_r_9*gap_0_2
    g_e_8 = g_0*g_r_2 + g_4*g_r_6 + g_8*g_r_10
    g_e_9 = g_1*g_r_2 + g_5*g_r_6 + g_9*g_r_10
    g_e_10 = g_10*g_r_10 + g_2*g_r_2 + g_6*g_r_6
    g_e_11 = g_r_10*gap_0_2 + g_r_2*gap_0_0 + g_r_6*gap_0_1
    # -- end --
    return (
        (g_e_0, g_e_1, g_e_2, g_e_3, g_e_4, g_e_5, g_e_6, g_e_7, g_e_8, g_e_9, g_e_10, g_e_11, 0.0,
         0.0, 0.0, 1.0),
    )


def _drift(
    g_e: Array, g: Array, g_r: Array,
) -> Array:
    """Square of the distance from the group."""
    # -- drift --
    g_e_0, g_e_1, g_e_2, g_e_4, g_e_5, g_e_6, g_e_8, g_e_9, g_e_10 = (
        g_e[0], g_e[1], g_e[2], g_e[4], g_e[5], g_e[6], g_e[8], g_e[9], g_e[10]
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
    off_9 = g_15 - 1.0
    off_13 = g_r_15 - 1.0
    # drift: square of the distance from the group [1]
    drift = (
        g_12*g_12 + g_13*g_13 + g_14*g_14 + g_r_12*g_r_12 + g_r_13*g_r_13 + g_r_14*g_r_14 +
        off_0*off_0 + off_1*off_1 + off_13*off_13 + off_2*off_2 + off_3*off_3 + off_4*off_4 +
        off_5*off_5 + off_9*off_9
    )
    # -- end --
    return (
        (drift,),
    )
