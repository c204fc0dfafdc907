(SOURCE the skip move of B-63944EN/02 20.4 ends without an alarm when no signal comes: a program that)
(SOURCE takes what it then reads for a measured position errs, one that compares it with the end of)
(SOURCE the way, 0.5 mm about it, has looked.  Any other comparison may have seen it or not: what is made)
(SOURCE of the result afterwards counts)

(CASE MT-01 a protected move whose end is compared is no finding)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
IF[ABS[#5061-50.]GT0.1]GOTO90
G00 X0
M30
N90 #3000=1(PATH OBSTRUCTED)
%
(EXPECT NO WARNING PRB301)

(CASE MT-02 the same through variables and sums of them)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#110=#5061
#111=#110-50.
#112=#111*2.
IF[#112EQ0]GOTO10
#3000=1(PATH OBSTRUCTED)
N10 M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-03 compared in a loop, and where the axes are instead of the skip position)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#1=#5041
WHILE[#1LT49.5]DO1
#1=#1+100.
END1
#100=#5061
M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-04 compared by the program that called)
(SIGNAL NONE)
%
O1
G65 P9
IF[#130GE50.]GOTO10
#3000=1(PATH OBSTRUCTED)
N10 M30
O9
G31 X50. F1000.
#130=#5061
M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-05 a value goes to a common variable and stays there)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#100=#5061-3.
M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-06 it is in a work offset)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#1=#5061
#5221=#1-3.
IF[#1GT49.]GOTO10
N10 M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-07 by G10)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#1=#5061
G10 L2 P1 X#1
#1=0
M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-08 in a tool offset, through a variable of a computed number)
(SIGNAL NONE)
%
O1
G31 Z-50. F1000.
#1=110
#[#1]=#5063
#2=#[#1+0]
#[#1]=0
#2001=#2
#2=0
M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-09 printed)
(SIGNAL NONE)
%
O1
POPEN
G31 X50. F1000.
#1=#5061
DPRNT[X#1[33]]
#1=0
PCLOS
M30
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-10 a size out of two touches of which one was none)
(SIGNAL X30.)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G00 X0
G31 X-50. F100.
#101=ABS[#1-#5061]
M30
%
(EXPECT WARNING PRB301 AT 8)

(CASE MT-11 the position as a position: the axes go there)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#101=#5061
G00 X0
G00 X#101
M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-12 many protected moves and nothing read: the last one alone is told)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
G31 X0 F1000.
M30
%
(EXPECT WARNING PRB301 AT 6)

(CASE MT-13 the signal itself is asked for)
(SIGNAL NONE)
%
O1
G31 X50. F100.
IF[#1000EQ1]GOTO10
G00 X0
N10 M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-14 a result that was compared with the end may be used: the program has looked)
(SIGNAL NONE)
%
O1
G31 X50. F100.
IF[#5061GT50.5]GOTO90
#5221=#5061
M30
N90 #3000=1(NO)
%
(EXPECT NO WARNING PRB301)

(CASE MT-15 a later touch settles nothing of an earlier miss)
(SIGNAL NONE)
(SIGNAL X20.)
%
O1
G31 X50. F100.
#100=#5061
G00 X0
G31 X50. F100.
#101=#5061
IF[#101GT0]GOTO10
N10 M30
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-16 what a macro keeps for itself is gone with it)
(SIGNAL NONE)
%
O1
G65 P9
M30
O9
G31 X50. F1000.
#1=#5061
M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-17 a macro gets it as an argument and compares)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#100=#5061
G65 P9 X#100
M30
O9
IF[#24GT40.]GOTO1
#3000=1(PATH OBSTRUCTED)
N1 M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-18 a macro gets it and makes an offset of it)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#100=#5061
G65 P9 X#100
#100=0
M30
O9
#5221=#24
M99
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-19 out of a sum, two levels further down)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
G65 P8 X[#5061-3.]
M30
O8
#1=#24*2.
G65 P9 A#1
M99
O9
G10 L2 P1 X#1
M99
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-20 the comparison is two levels further down)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
G65 P8 X[#5061-3.]
#500=#5061
M30
O8
G65 P9 A#24
M99
O9
IF[#1GT46.9]GOTO1
#3000=1(PATH OBSTRUCTED)
N1 M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-21 a macro that compares another argument has not looked)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#100=#5061
G65 P9 X#100 Y1.
#100=0
M30
O9
IF[#25GT40.]GOTO1
#2001=#24
N1 M99
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-22 a macro goes there: a position)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#100=#5061
G65 P9 X#100
M30
O9
G00 X0
G00 X#24
M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-23 a macro gives it back, made of its argument)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
G65 P9 X#5061
IF[#101GT40.]GOTO1
#3000=1(PATH OBSTRUCTED)
N1 M30
O9
#101=#24-1.
M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-24 and nobody looks at what it gives back)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
G65 P9 X#5061
#5221=#101
#101=0
M30
O9
#101=#24-1.
M99
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-25 a limit that the end keeps, too, finds nothing)
(SIGNAL NONE)
%
O1
G31 X50. F100.
IF[#5061GT100.]GOTO90
#5221=#5061
M30
N90 #3000=1(NO)
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-26 a limit that it does not keep: nothing is made of it)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#100=#5061
IF[ABS[#100-30.]LT5.]GOTO1
#101=0
M30
N1 #101=#100
M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-27 a test for 0 finds nothing)
(SIGNAL NONE)
%
O1
G31 X10. F100.
#4=#5061
IF[ABS[#4]LT.00000001]THEN#4=0
#100=#4
M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-28 the least of three touches, the second of which was none)
(SIGNAL X30.)
(SIGNAL NONE)
(SIGNAL X40.)
%
O1
G00 X60.
#5=999.
#1=0
WHILE[#1LT3.]DO1
G31 X-50. F100.
#4=#5061
G00 X60.
IF[#4LT#5]THEN#5=#4
#1=#1+1
END1
#100=#5
M30
%
(EXPECT WARNING PRB301 AT 10)

(CASE MT-29 the least of touches that were none, all with one end)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X-50. F100.
#5=#5061
G00 X60.
G31 X-50. F100.
#4=#5061
IF[#4LT#5]THEN#5=#4
#100=#5
M30
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-30 compared with what it has nothing to do with)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#4=#5061
IF[1EQ#4]GOTO1
N1 #2001=#4
M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-31 whether it is vacant says nothing of it)
(SIGNAL NONE)
%
O1
G31 X0.5 F100.
#100=#5061
IF[#100EQ#0]GOTO1
N1 M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-32 an inch is not 1 mm)
(SIGNAL NONE)
%
O1
G20
G31 X2. F10.
IF[#5061GT1.5]GOTO1
N1 #500=#5061
M30
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-33 in inches, too, the end is compared with some play)
(SIGNAL NONE)
%
O1
G20
G31 X2. F10.
IF[ABS[#5061-2.]GT.004]GOTO1
N1 #500=#5061
M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-34 the end of the second way was made of the first: it is compared as a position)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
#1=#5061+10.
G31 X#1 F1000.
IF[#5061LT#1]GOTO90
#500=#5061
M30
N90 #3000=1(PATH OBSTRUCTED)
%
(EXPECT NO WARNING PRB301)

(CASE MT-35 the place where the axes stand tells of a miss as well)
(SIGNAL NONE)
%
O1
G31 X50. F1000.
IF[#5041EQ#5061]GOTO10
#500=#5061
N10 M30
%
(EXPECT NO WARNING PRB301)

(CASE MT-36 another input tells nothing of the signal: a battery)
(SIGNAL NONE)
%
O1
G91 G31 X15. F50.
#769=#5061+3.
IF[#1005EQ0]GOTO99
#3000=45(BATTERY)
N99 M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-37 two that were none scatter by nothing)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G00 X0
G31 X50. F100.
#2=#5061
IF[ABS[#1-#2]GT.01]GOTO99
#5221=[#1+#2]/2.
M30
N99 #3000=1(SCATTER)
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-38 a macro touches twice, the caller looks at the second one)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G65 P9100 X50. A101.
G65 P9100 X70. A102.
IF[#102GT69.9]THEN#102=#0
#5221=#101+3.
#101=0
M30
O9100
G31 X#24 F100.
#[#1]=#5061
G00 X0
M99
%
(EXPECT WARNING PRB301 AT 12)

(CASE MT-39 a modal call gets it)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G66 P2 A#1
#1=0
G00 X0
G67
M30
O2
#500=#1
M99
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-40 the program looks before the modal call is made)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G66 P2 A#1
IF[#1GT49.9]GOTO1
N1 G00 X0
G67
M30
O2
#500=#1
M99
%
(EXPECT NO WARNING PRB301)

(CASE MT-41 the rotation of the part)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G00 X0
G31 X60. F100.
#2=#5061
G68 X0 Y0 R[ATAN[#2-#1]/[30.]]
G69
#1=0
#2=0
M30
%
(EXPECT WARNING PRB301 AT 5)

(CASE MT-42 a small step beyond a face that is not there)
(SIGNAL NONE)
%
O1
G31 Z-1. F100.
#1=#5063
IF[ABS[#1]LT.002]GOTO10
#5223=#5223+#1
N10 M30
%
(EXPECT WARNING PRB301 AT 4)

(CASE MT-43 a modal call keeps each argument by itself)
(SIGNAL NONE)
(SIGNAL NONE)
%
O1
G31 X50. F100.
#1=#5061
G00 X0
G31 X70. F100.
#2=#5061
G66 P2 A#1 B#2
IF[#1GT49.9]GOTO1
N1 #2=0
G00 X0
G67
M30
O2
#500=#1
M99
%
(EXPECT NO WARNING PRB301)

(CASE G37 without its signal is the alarm, and the G31 before it is told as ever)
(CONTROL fanuc-16i)
%
O1
G90 G21
G43 H1
G31 Z-5. F100
G37 Z-50.
M30
%
(EXPECT WARNING PRB301 AT 6)
(EXPECT NO WARNING PRB302)
(EXPECT ALARM 80 AT 7)
