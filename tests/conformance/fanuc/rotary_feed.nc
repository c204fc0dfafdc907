(What F means where an axis turns.)
(SOURCE FANUC operator's manual B-63174EN/03, G01: a degree counts as a millimetre; G91 G01 X20. C40. F300. takes 8.94 s, sqrt[20^2+40^2]/300 minutes)
(SHEET [machine.axes.C])
(SHEET travel = [-3600.0, 3600.0])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.X])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.Y])
(SHEET acceleration = 1e9)

(CASE a linear and a rotary axis: sqrt[20^2+40^2]/300 minutes are 8.9443 s)
%
O1
#3001=0
G91 G01 X20. C40. F300.
#100=#3001
M30
%
(EXPECT #100 = 8944)

(CASE three axes: sqrt[20^2+40^2+40^2]/300 minutes are 12 s)
%
O1
#3001=0
G91 G01 X20. Y40. C40. F300.
#100=#3001
M30
%
(EXPECT #100 = 12000)

(CASE a rotary axis alone: degrees in a minute)
%
O1
#3001=0
G91 G01 C40. F300.
#100=#3001
M30
%
(EXPECT #100 = 8000)

(CASE linear axes alone are as ever)
%
O1
#3001=0
G91 G01 X30. Y40. F300.
#100=#3001
M30
%
(EXPECT #100 = 10000)

(CASE in inches a degree counts as an inch)
%
O1
G20
#3001=0
G91 G01 X3. C4. F60.
#100=#3001
G01 C4. F60.
#101=#3001
M30
%
(EXPECT #100 = 5000)
(EXPECT #101 = 9000)

(CASE a skip move, too)
%
O1
#3001=0
G91 G31 X20. C40. F300.
#100=#3001
M30
%
(EXPECT #100 = 8944)
