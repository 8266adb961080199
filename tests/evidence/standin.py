import shutil, numpy as np, sys
from pathlib import Path
from derive.native.compile import *
from derive.native.load import Library
ROOT = Path(__file__).parents[2]
def quat(ax,a):
    ax=np.array(ax,float); ax/=np.linalg.norm(ax); return np.r_[np.cos(a/2),np.sin(a/2)*ax]
def mul(p,q):
    a,b,c,d=p;e,f,g,h=q
    return np.array([a*e-b*f-c*g-d*h,a*f+b*e+c*h-d*g,a*g-b*h+c*e+d*f,a*h+b*g-c*f+d*e])
def R(q):
    w,x,y,z=q
    return np.array([1-2*(y*y+z*z),2*(x*y-w*z),2*(x*z+w*y),2*(x*y+w*z),1-2*(x*x+z*z),2*(y*z-w*x),2*(x*z-w*y),2*(y*z+w*x),1-2*(x*x+y*y)])
def fnv(b):
    s=2166136261
    for x in b: s=((s^x)*16777619)&0xffffffff
    return s
def place(name, folder):
    root=folder/name
    shutil.copytree(ROOT/"generated"/name, root)
    (root/"test").mkdir()
    st = R if (root/f"c/include/{name}_f32.h").read_text().find("float g[9]")>0 else (lambda q:q)
    for sc in ("f32","f64"):
        P=f"{name}_{sc}"; dt=np.float32 if sc=="f32" else float
        lib=build([root/f"c/src/{P}.c"], root/"c/include", folder/"lib"/name)
        import cffi
        from derive.native.header import parse
        ffi=cffi.FFI(); ffi.cdef(parse((root/f"c/include/{P}.h").read_text()).declarations); L=ffi.dlopen(str(lib))
        rows=[]; qr=quat((1,-2,1),1.1)
        for a in [0,1e-8,1e-3,.1,.5,1,1.5,2,2.5,3,np.pi-1e-3,np.pi-1e-6,np.pi]:
            for ax in [(1,0,0),(0,1,0),(0,0,1),(1,2,3),(-3,1,-2)]:
                rows.append((st(mul(qr,quat(ax,a))),(.3,-.2,.5),st(qr),(.1,.4,-.2),(.01,-.02,.05)))
        rows.append((st(qr)*2,(.3,-.2,.5),st(qr),(.1,.4,-.2),(.01,-.02,.05)))
        out=[]
        s=ffi.new(P+"_state*"); r=ffi.new(P+"_reference*"); c=ffi.new(P+"_command*")
        X=lambda v:"{"+",".join(float(dt(x)).hex()+("f" if sc=="f32" else "") for x in v)+"}"
        for g,nu,gr,nur,nurd in rows:
            s.g=list(map(float,g)); s.nu=nu; r.g=list(map(float,gr)); r.nu=nur; r.nu_dot=nurd
            status=getattr(L,P+"_control")(getattr(ffi.addressof(L,P+"_defaults"),"__class__") and ffi.addressof(L,P+"_defaults"),s,r,c)
            b=bytes(ffi.buffer(c))
            n=[list(getattr(c,k)) for k in ("force","s","nu_u","nu_u_dot")]
            out.append("{{"+X(g)+","+X(nu)+"},{"+X(gr)+","+X(nur)+","+X(nurd)+"},{"+",".join(map(X,n))+f"}},({P}_status){status},{fnv(b)}u}}")
        M=P.upper()
        (root/f"test/{P}_test.h").write_text(f'''#include <stdint.h>
#include "{P}.h"
#define {M}_CASES {len(out)}
typedef struct {{ {P}_state state; {P}_reference reference; {P}_command truth; {P}_status status; uint32_t bits; }} {P}_case;
extern const {P}_case {P}_cases[{M}_CASES];
int {P}_test(void);
''')
        (root/f"test/{P}_test.c").write_text(f'#include "{P}_test.h"\nconst {P}_case {P}_cases[] = {{\n'+",\n".join(out)+f"\n}};\nint {P}_test(void) {{ return 0; }}\n")
    return root
if __name__=="__main__":
    for n in sys.argv[2:]: place(n, Path(sys.argv[1]))
