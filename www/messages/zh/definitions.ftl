# 定义文件和赋值程序。

definitions-intro = 此机床在测量循环定义文件（新控制系统：设定数据和机床数据）中的改动：与出厂状态不同的数组大小和数值、给其余数据赋值的程序，以及所需的存储器。
definitions-channels-label = 进行测量的通道数
definitions-read-files = 读回文件
definitions-save-file = 保存 { $name }
definitions-array = 数组
definitions-scope = 存储器
definitions-bytes = 字节
definitions-delivered = 出厂时
definitions-of-channel = 每个通道
definitions-of-control = 控制系统
